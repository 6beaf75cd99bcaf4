// Rows of joints in the direct solver's groups: from the lanes in which they are made, and back.
#pragma once

#include "dynamics/solver/direct.h"

namespace carom::dynamics {

/// What rows are asked for.
enum class LinkPhase : std::uint8_t {
  move,    // velocities that lead back onto the joint at the end of the substep
  part,    // displacements that undo what is left of an error
  settle,  // velocities along the joint, where the move has ended
};

/// Add the rows of a group's joints, its bodies and their couplings.
void gather_links(const World& world, DirectGroups& d, std::size_t group);

/// Rows where bodies are now, and what is asked of them. Impulses are those kept, or none but in `move`.
/// @param problem  bodies' velocities are those of the state
/// @param most     m or rad, of an error that is undone, in `part`
void load_links(const World& world, ConeProblem& problem, const DirectGroups::LinkRow* rows, LinkPhase phase, Real h,
                Real most = 0);
/// Make bodies turn slower that a joint's force would swing faster than substeps can follow. A force f at an arm r is a
/// spring of f r against turns across it: a link of 1 kg and 0.5 m that 1e5 N pull swings at 800 rad/s, and a scheme
/// that is explicit in directions throws it about beyond 2 / h. So its inertia becomes at least f r h^2 / 2 and its
/// momentum stays, which is what a linearly implicit step does: it turns slower and loses energy. Who is resolved keeps
/// both.
///  @source [Andrews2017] adds such a term; @param problem  bodies' masses are their own
/// @param borne  by joints: in the last substep, or where lanes know but a part of that in the last step
enum class Borne { in_substep, in_step };
void stiffen(const World& world, ConeProblem& problem, const DirectGroups::LinkRow* rows, Real h, Borne borne);
/// Whether the impulses that were found are so much larger than those kept that somebody needs to be stiffer.
bool is_jerked(const World& world, ConeProblem& problem, const DirectGroups::LinkRow* rows, Real h);
/// Locks bend by where their bodies go as the substep begins. What slides along an axis of A and is gripped does not go on so: it
/// has the coordinate rate of the substep before, or it would be flung outwards. ConeLink::curve of locks, by that.
void bend_as_gripped(const World& world, ConeProblem& problem, const DirectGroups::LinkRow* rows, Real h);
/// Velocities at rows, from the bodies'.
void measure_links(ConeProblem& problem);
/// Add the impulses to the step's.
void accumulate_links(const World& world, const ConeProblem& problem, const DirectGroups::LinkRow* rows);
/// Keep what the next substep starts from.
void keep_links(const World& world, const ConeProblem& problem, const DirectGroups::LinkRow* rows);
/// m or rad: the largest error of what is locked and limited.
/// Rotors have what they gave their axes the other way round.
void turn_rotors(const World& world, const ConeProblem& problem, const DirectGroups::LinkRow* rows);
Real worst_error(const World& world, const ConeProblem& problem, const DirectGroups::LinkRow* rows);

}  // namespace carom::dynamics
