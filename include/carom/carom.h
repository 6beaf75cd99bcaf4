/** @file carom.h
 *  All of Carom's C interface.
 */
#ifndef CAROM_CAROM_H
#define CAROM_CAROM_H

#include <carom/accuracy.h>
#include <carom/base.h>
#include <carom/batch.h>
#include <carom/body.h>
#include <carom/body_bulk.h>
#include <carom/cast.h>
#include <carom/character.h>
#include <carom/dial.h>
#include <carom/draw.h>
#include <carom/engine.h>
#include <carom/events.h>
#include <carom/filter.h>
#include <carom/force.h>
#include <carom/joint.h>
#include <carom/ledger.h>
#include <carom/pairs.h>
#include <carom/particles.h>
#include <carom/plan.h>
#include <carom/plugin.h>
#include <carom/query.h>
#include <carom/record.h>
#include <carom/residuals.h>
#include <carom/scenery.h>
#include <carom/shape.h>
#include <carom/snapshot.h>
#include <carom/tree.h>
#include <carom/vehicle.h>
#include <carom/world.h>
#include <carom/world_query.h>

#endif
