// Contacts of what turns far within a step, asked again in each substep.
//
// A contact is found as a step begins, and goes on with its bodies. That is right where a corner stands. Where a cone or a
// stone rolls its point goes round it, a point of the beginning rises, and it sinks meanwhile: by r t^2 / 2 if it turns by t. A box that
// tips comes down on a corner that was not asked for. So pairs whose points leave their tangents by more than a share of
// tolerable_depth() within the step are asked again where they are by then. Rows stay: the deepest points go to the nearest rows, and a
// row that has none keeps the point of its bodies that it had.
//
// Past the edge of its collider a pair sees an edge, which leans. Where a flush neighbour bears the body in the same plane its points
// are taken: its own contact was none as the step began, for it was a ghost (seams.h), out of reach or the sweep's.
//
// Of contacts that the direct solver solves.
// @oracle tests/stability/test_tumbling; carom jury
#pragma once

#include "core/constant.h"
#include "dynamics/contact/contact.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kAskedAgain{
    "asked_again", 0.1, "1",
    "of tolerable_depth(), by which points of a body may leave the tangent of their way within a step before its contacts are asked "
    "again in each substep",
    "larger: what rolls and tumbles sinks; smaller: time, for what hardly turns"};
inline constexpr ConstantRow kAskedAgainConstants[] = {kAskedAgain};

/// Whether contacts of a pair may be asked again in this step, as their bodies turn.
bool may_be_asked_again(const World& world, const Pair& pair, const StepTime& time);
/// Which, as rows are made: RowGeometry::is_asked_again, Contacts::any_asked_again.
void find_asked_again(const World& world, const StepTime& time);
/// Stage function of the page.
void ask_again(const World& world, StepReport& report, const StepTime& time);

}  // namespace carom::dynamics
