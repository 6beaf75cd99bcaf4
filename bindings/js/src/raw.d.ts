// Written by bindings/gen/generate from include/carom; do not edit.
/** The C interface as the module exports it. A pointer is an offset into `memory`. */
export interface Raw {
  memory: WebAssembly.Memory;
  malloc(bytes: number): number;
  free(pointer: number): void;
  /** Version of the library that is running (the CAROM_VERSION_* macros are the header's).
   *  @param major, minor, patch as CAROM_VERSION_*
   *  @status OK; NULL_ARGUMENT */
  carom_version(major: number, minor: number, patch: number): number;
  /** Name of a result code, e.g. "CAROM_E_BUSY"; "CAROM_E_?" for an unknown one. Static storage.
   *  @param result of any call */
  carom_result_name(result: number): number;
  /** What to do about a result code, in one sentence. Static storage.
   *  @param result of any call */
  carom_result_remedy(result: number): number;
  /** The layout of every struct of this interface, as the compiler that built this library has it: for a binding, which
   *  compares it with its own when it is loaded. Lines of four words, ending in '\n'; first "carom" and the version:
   *      carom 0.9.0
   *      carom_error 0 576 struct              name, offset, size in bytes, kind
   *      carom_error.struct_size 0 4 u32
   *      carom_error.witness_dir 16 24 f64[3]
   *  Kinds: u32, i32, u64 (handles too), f64, char, ptr, fn (pointer to a function), struct; [n] behind it: an array.
   *  Newer libraries have more lines, and a struct may be larger; a field stays as it is.
   *  Static storage. */
  carom_abi_manifest(): number;
  /** Is this library what a client was built for? As bindings ask when they have loaded it: of the same major version and
   *  not older (of the same minor version before 1.0), and with the same structs, some of which may be larger here.
   *  @param layout  of the client: lines of carom_abi_manifest(), the first with its version, zero-terminated
   *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (no line of a version); UNSUPPORTED (the message names this library's file, and the
   *          first line that differs) */
  carom_abi_check(layout: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_accuracy_init(accuracy: number, struct_size: number): number;
  /** Set an error tolerance from the next step on.
   *  @param accuracy NULL: none, as a world is created
   *  @status OK; UNSUPPORTED; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE (also where both place and turn are
   *  0);
   *          BUSY; REENTRANT */
  carom_world_set_accuracy(world: number, accuracy: number, error: number): number;
  /** @param accuracy out   @param present out: 1 or 0; if 0, accuracy is filled with defaults
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
  carom_world_get_accuracy(world: number, accuracy: number, present: number, error: number): number;
  /** Copy out the islands of the last step, worst first: by share, then by body. None without a tolerance.
   *  Bodies in free flight are in none: nothing acts on them but what is constant, and their step is exact.
   *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
   *  @param stride   sizeof(carom_island) as the caller knows it
   *  @param count    out: how many there are (may exceed capacity; capacity are written)
   *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
  carom_world_get_islands(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** Measure how errors grow from here. Two copies of the world take the steps, at its dials and accuracy, so it costs a
   *  little over twice as much as they; nothing of the world itself changes. The same world gives the same result.
   *  Errors grow e-fold (`sensitive`) where they grow a hundredfold or more, and a quarter of the time or more goes by
   *  until they have grown to the root of that: half of it in chaos, a tenth where they grow in proportion to time.
   *  @param dt      s, of a step: as for carom_world_step()
   *  @param steps   1 to 1000000: several e-foldings of what is looked for, and more than the longest period
   *  @param growth  out, its struct_size set
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY
   *  @thread reader */
  carom_world_measure_growth(world: number, dt: number, steps: number, growth: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_batch_column_init(column: number, struct_size: number): number;
  /** Make a batch without worlds.
   *  @param batch out: to be destroyed before the engine   @owns the caller: carom_batch_destroy()
   *  @status OK; NULL_ARGUMENT; OUT_OF_MEMORY   @thread engine */
  carom_batch_create(engine: number, batch: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; BUSY; REENTRANT */
  carom_batch_destroy(batch: number, error: number): number;
  /** Add n worlds that are as this one is now. The world itself is read, stays as it is, and may be destroyed. A ledger, a
   *  recording and a budget of time are not copied.
   *  @param batch of the same engine   @param n 1 to 2^24 in all   @param first out: the number of the first of them
   *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); WRONG_WORLD (of another engine); LIMIT (256 structures in all); BUSY;
   *          REENTRANT; OUT_OF_MEMORY */
  carom_batch_add_worlds(batch: number, world: number, n: bigint, first: number, error: number): number;
  /** Say where numbers of worlds stand.
   *  @param column out: its number, from 0 on; may be NULL
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; OUT_OF_RANGE (world, n, a ray); NOT_FINITE; *_HANDLE;
   *          UNSUPPORTED (a joint or body that has no such field; read only: not BEFORE_STEP, nor fields that move
   *          joints); BUFFER_TOO_SMALL (stride); LIMIT (4,096 columns); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_batch_add_column(batch: number, desc: number, column: number, error: number): number;
  /** Advance worlds, each by steps of dt. First, all that columns BEFORE_STEP have for them is checked: where something is
   *  refused no world has moved. A world that is stopped stays as it is, and so do its rows.
   *  @param mask     [worlds] or NULL: all
   *  @param dt       s, in [1e-9, 1]
   *  @param steps    1 to 1e6, with the same numbers before each
   *  @param stopped  out: how many worlds are stopped now, in all; may be NULL
   *  @status OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED; BUSY; REENTRANT; OUT_OF_MEMORY; INTERNAL (a
   *          callback left its thread: some worlds were stepped) */
  carom_batch_step(batch: number, mask: number, dt: number, steps: number, stopped: number, error: number): number;
  /** Read columns, of worlds as they are now. Contact forces are those of a step: 0 here.
   *  @param columns [count]   @param mask [worlds] or NULL: all
   *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (a column); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_batch_read(batch: number, columns: number, count: bigint, mask: number, error: number): number;
  /** Write columns, one after the other: poses, speeds, gains, friction, masses. All worlds or none are changed.
   *  @param columns [count]   @param mask [worlds] or NULL: all
   *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE; NOT_FINITE; NOT_UNIT; UNSUPPORTED (read only, or joints that can't be moved);
   *          BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_batch_write(batch: number, columns: number, count: bigint, mask: number, error: number): number;
  /** Add a state that worlds of a structure may be reset to.
   *  @param world  one of the structure   @param bytes [size] as carom_world_restore() takes them   @param size of bytes
   *  @param start  out: its number among those of the structure, from 1 on; 0 is the state that its worlds were made with
   *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (world); CORRUPT; UNSUPPORTED; MISMATCH; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_batch_add_start(batch: number, world: bigint, bytes: number, size: bigint, start: number, error: number): number;
  /** Put worlds back to where they began. Masses that were written stay; what else was written is as in the start.
   *  A world that is stopped runs again.
   *  @param mask   [worlds] or NULL: all   @param starts [worlds] numbers of starts, or NULL: 0
   *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (a start); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_batch_reset(batch: number, mask: number, starts: number, error: number): number;
  /** Write a snapshot of one world, as carom_world_save() with CAROM_SNAPSHOT_STATE: it goes into the world that was
   *  copied (unless masses differ), or back by carom_batch_add_start(). Arguments as there.
   *  @param world    its number
   *  @param buffer   [capacity] bytes, or NULL to get the size alone
   *  @param capacity bytes; 0 if buffer is NULL
   *  @param needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
   *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (world); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_batch_save(batch: number, world: bigint, buffer: number, capacity: bigint, needed: number, error: number): number;
  /** The hash of each world, as carom_world_hash().
   *  @param hashes out, [worlds]   @param n how many worlds there are
   *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_batch_get_hashes(batch: number, hashes: number, n: bigint, error: number): number;
  /** Which worlds are stopped, and why.
   *  @param stopped out, [worlds] CAROM_STOPPED_*   @param n how many worlds there are
   *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); BUSY */
  carom_batch_get_stopped(batch: number, stopped: number, n: bigint, error: number): number;
  /** The faults of the step that stopped a world; none where it is not stopped.
   *  @param world    its number
   *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
   *  @param stride   sizeof(carom_fault) as the caller knows it
   *  @param count    out: how many there are (may exceed capacity; capacity are written)
   *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (world, stride); BUSY */
  carom_batch_get_faults(batch: number, world: bigint, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
  carom_batch_get_info(batch: number, info: number, error: number): number;
  /** Random numbers that follow from a key alone: n rows, each from its own key. So they do not depend on how many worlds
   *  there are, in which order or on which thread, or machine, they are drawn. Philox4x32-10; the normal ones by Box and
   *  Muller. A row that is longer begins as a shorter one of its key.
   *  @param kind  CAROM_RANDOM_*
   *  @param keys  [3 n]: of each row a seed, the number of a world, a step
   *  @param width numbers in a row
   *  @param dst   out, [n width]
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; OUT_OF_RANGE (n, width)   @thread any */
  carom_random_fill(kind: number, keys: number, n: bigint, width: bigint, dst: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_material_desc_init(desc: number, struct_size: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY; OUT_OF_MEMORY */
  carom_material_create(world: number, desc: number, material: number, error: number): number;
  /** Change a material in place; every collider that uses it follows.   @status as carom_material_create(); *_HANDLE */
  carom_material_update(world: number, material: bigint, desc: number, error: number): number;
  /** Resistance of a surface to rolling and to spinning about the normal, 0 when it is created. A contact that presses
   *  with a force N bears a moment of up to rolling * N in its plane and of up to spinning * N about its normal. Mixed as
   *  friction is; carom_material_update() leaves it alone.
   *  @param rolling, spinning m, [0, 1e3]
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY */
  carom_material_set_resistance(world: number, material: bigint, rolling: number, spinning: number, error: number): number;
  /** @param rolling, spinning out: m   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_material_get_resistance(world: number, material: bigint, rolling: number, spinning: number, error: number): number;
  /** Say what two materials are to each other, instead of mixing them. Wakes what touches so. It ends with either material.
   *  @param material_a, material_b  in any order; the same twice: colliders of that material among themselves
   *  @param surface [4] friction, [0, 1e3]; restitution, [0, 1]; resistance to rolling and to spinning, m, [0, 1e3].
   *                 NULL: they mix again
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY   @since 0.9 */
  carom_material_set_pair(world: number, material_a: bigint, material_b: bigint, surface: number, error: number): number;
  /** What two materials are to each other: what was said of them, or else what they mix to.
   *  @param surface out, [4]: as carom_material_set_pair() takes it
   *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY   @since 0.9 */
  carom_material_get_pair(world: number, material_a: bigint, material_b: bigint, surface: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider uses it); BUSY */
  carom_material_destroy(world: number, material: bigint, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_body_desc_init(desc: number, struct_size: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY;
   *          REENTRANT; LIMIT; OUT_OF_MEMORY */
  carom_body_create(world: number, desc: number, body: number, error: number): number;
  /** Destroys its colliders too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
  carom_body_destroy(world: number, body: bigint, error: number): number;
  /** Everything there is to know about a body, with its masses as the engine uses them (fields: all of FIELD_* set; a
   *  body that cannot rotate reports zero inertia; a static or kinematic body reports mass 0).
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
  carom_body_get(world: number, body: bigint, desc: number, error: number): number;
  /** @param position [3] m   @param orientation [4] x, y, z, w   @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE;
   *  NOT_UNIT; BUSY; REENTRANT */
  carom_body_set_pose(world: number, body: bigint, position: number, orientation: number, error: number): number;
  /** @param linear [3] m/s of the centre of mass   @param angular [3] rad/s, both world frame
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a static body must have 0); BUSY; REENTRANT */
  carom_body_set_velocity(world: number, body: bigint, linear: number, angular: number, error: number): number;
  /** @param position [3] out, or NULL: m, world, origin of the body frame   @param orientation [4] out, or NULL: x, y, z,
   *  w, body to world   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_pose(world: number, body: bigint, position: number, orientation: number, error: number): number;
  /** @param linear [3] out, or NULL: m/s, world, of the centre of mass   @param angular [3] out, or NULL: rad/s, world
   *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_velocity(world: number, body: bigint, linear: number, angular: number, error: number): number;
  /** Set the mass of a dynamic body, as carom_body_desc would have. Its frame stays; the velocity of its centre is kept
   *  as that of the new centre. Wakes the body and its island. Snapshots of before do not fit any more (MISMATCH).
   *  @param mass kg, at least 1e-300; or 0: from the densities of its colliders, with center and inertia NULL
   *  @param center [3] m, body frame, or NULL: from its colliders
   *  @param inertia [9] kg m^2, body frame axes, about the centre, row-major, symmetric, positive definite or all zero;
   *  or NULL:
   *                 from its colliders, scaled to the mass
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a body that is not dynamic); NO_VOLUME (mass 0,
   *          and a collider is flat); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_body_set_mass(world: number, body: bigint, mass: number, center: number, inertia: number, error: number): number;
  /** As the engine uses them: mass 0 of a body that is not dynamic, inertia 0 of one that cannot rotate.
   *  @param mass out, or NULL: kg   @param center [3] out, or NULL: m, body frame   @param inertia [9] out, or NULL: kg
   *  m^2, body frame axes, about the centre, row-major   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_mass(world: number, body: bigint, mass: number, center: number, inertia: number, error: number): number;
  /** Make a static, kinematic or dynamic body of one that is there. A body that becomes static stops. One that is dynamic
   *  no longer loses the mass that it was given, pending forces and what only dynamic bodies may have
   *  (carom_attribute_info.of_dynamic). Snapshots of before do not fit any more. What it touches wakes.
   *  @param type CAROM_BODY_*
   *  @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; OUT_OF_RANGE (a half-space needs a static body, scenery one that
   *          is not dynamic; a joint or a spring needs a dynamic one); NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_body_set_type(world: number, body: bigint, type: number, error: number): number;
  /** @param type out: CAROM_BODY_*   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_type(world: number, body: bigint, type: number, error: number): number;
  /** @param linear, angular 1/s, [0, 1e6]: dv/dt = -linear v, likewise of spin   @status OK; NULL_ARGUMENT; *_HANDLE;
   *  NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_body_set_damping(world: number, body: bigint, linear: number, angular: number, error: number): number;
  /** @param linear, angular out: 1/s; either may be NULL   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_damping(world: number, body: bigint, linear: number, angular: number, error: number): number;
  /** @param user anything; the engine does not look   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
  carom_body_set_user(world: number, body: bigint, user: bigint, error: number): number;
  /** @param user out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_user(world: number, body: bigint, user: number, error: number): number;
  /** Number of a body's colliders, and their handles in the order of the slots.
   *  @param colliders [capacity] or NULL   @param count out: how many there are (may exceed capacity; capacity are
   *  written)
   *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_colliders(world: number, body: bigint, colliders: number, capacity: bigint, count: number, error: number): number;
  /** Add a force and a torque about the centre of mass, for the next step only.
   *  @param force [3] N, world   @param torque [3] N m, world
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT */
  carom_body_add_force(world: number, body: bigint, force: number, torque: number, error: number): number;
  /** Change velocities at once. @param impulse [3] N s, world   @param point [3] m, world: where it acts
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the velocity would overflow); BUSY; REENTRANT */
  carom_body_add_impulse(world: number, body: bigint, impulse: number, point: number, error: number): number;
  /** How much of the world's gravity acts on a body: its weight is mass * factor * gravity. With 0 it floats, below 0 it
   *  rises. 1 - c compensates a share c of its gravity, as a counterweight does; inverse dynamics counts it (tree.h). Wakes the body and its island.
   *  @param factor any finite number; 1 when a body is created
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_body_set_gravity_factor(world: number, body: bigint, factor: number, error: number): number;
  /** @param factor out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_gravity_factor(world: number, body: bigint, factor: number, error: number): number;
  /** Hold the velocity of a dynamic body along and about some world axes at 0, exactly: forces, contacts and joints move
   *  it along the others alone, as heavy there as it is. What it has of such velocity now is gone; what a host writes of
   *  it later is dropped; a pose that a host sets is taken, and kept from then on. Wakes the body and its island.
   *  
   *  Every solver but CAROM_SOLVER_SEVERITY knows locks: a world with that dial refuses them, and a world with a locked
   *  body refuses that dial.
   *  @param locks CAROM_LOCK_* bits, 0 when a body is created
   *  @status OK; NULL_ARGUMENT; *_HANDLE; UNSUPPORTED (unknown bits; or solver severity: set CAROM_DIAL_SOLVER to another
   *          first); OUT_OF_RANGE (a body that is not dynamic: it moves as its velocity says); BUSY; REENTRANT;
   *          OUT_OF_MEMORY */
  carom_body_set_locks(world: number, body: bigint, locks: number, error: number): number;
  /** @param locks out: CAROM_LOCK_* bits   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_locks(world: number, body: bigint, locks: number, error: number): number;
  /** @param attribute CAROM_ATTRIBUTE_*   @param info out
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM */
  carom_attribute_get_info(attribute: number, info: number, error: number): number;
  /** Set an attribute. Another value than it has wakes the body and its island.
   *  @param value [4] in the units of carom_attribute_info; numbers that the attribute does not have must be 0
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a fraction where numbers are
   *  whole; a
   *          body that is not dynamic); UNSUPPORTED (locks under solver severity); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_body_set_attribute(world: number, body: bigint, attribute: number, value: number, error: number): number;
  /** @param value [4] out: numbers that the attribute does not have are 0
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; BUSY */
  carom_body_get_attribute(world: number, body: bigint, attribute: number, value: number, error: number): number;
  /** @param asleep out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_is_asleep(world: number, body: bigint, asleep: number, error: number): number;
  /** Wake a body and its island; if it is awake, its time of rest starts anew.   @status OK; NULL_ARGUMENT; *_HANDLE;
   *  BUSY; REENTRANT */
  carom_body_wake(world: number, body: bigint, error: number): number;
  /** Say when a body is swept, from the next step on. Without effect on a static body, and where CAROM_DIAL_CONTINUOUS
   *  says otherwise: under CAROM_SWEEP_NONE no body is swept, under CAROM_SWEEP_FLAGGED only CAROM_CONTINUOUS_ALWAYS.
   *  @param mode CAROM_CONTINUOUS_*
   *  @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (mode: pass one of CAROM_CONTINUOUS_*); BUSY; REENTRANT */
  carom_body_set_continuous(world: number, body: bigint, mode: number, error: number): number;
  /** @param mode out: CAROM_CONTINUOUS_*   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_continuous(world: number, body: bigint, mode: number, error: number): number;
  /** Take a body out of steps, or back in, from the next step on. A disabled body keeps its pose and velocity. Nothing
   *  moves it, it touches nothing, and its joints and springs hold nothing. Queries do not find it. Bodies that rested on
   *  it wake. It costs a step nothing. A host may still read and write it.
   *  @param enabled 1 or 0
   *  @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (enabled: pass 0 or 1); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_body_set_enabled(world: number, body: bigint, enabled: number, error: number): number;
  /** @param enabled out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_is_enabled(world: number, body: bigint, enabled: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_collider_desc_init(desc: number, struct_size: number): number;
  /** Put a shape on a body; the body's mass properties follow. The body's linear velocity is kept as that of its new
   *  centre.
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a
   *  half-space on a
   *          body that moves); NO_VOLUME (a flat shape needs CAROM_BODY_FIELD_MASS or density 0); BUSY; REENTRANT;
   *          OUT_OF_MEMORY */
  carom_collider_create(world: number, body: bigint, desc: number, collider: number, error: number): number;
  /** The common case in one call: a shape by name, a body, and a collider of density 1000. A shape of that name with the
   *  same parameters that the engine has is used again; a new one lives as long as the engine, or until it is destroyed.
   *  Where a part of it fails nothing has changed, but for a plugin that was loaded. Its orientation is the identity, its
   *  friction 0.5, its restitution 0. carom_body_get_colliders() gives its collider.
   *  @param type CAROM_BODY_*   @param name as carom_shape_create_named()   @param position [3] m, world
   *  @param params [count] as carom_shape_create_named()   @param count number of params
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; PLUGIN_PATH; PLUGIN_LOAD;
   *          PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY */
  carom_body_create_named(world: number, type: number, name: number, params: number, count: bigint, position: number, body: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
  carom_collider_destroy(world: number, collider: bigint, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
  carom_collider_get(world: number, collider: bigint, desc: number, body: number, error: number): number;
  /** Give a collider another material. Wakes what its body touches.   @param material or CAROM_NULL_HANDLE: friction 0.5,
   *  restitution 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_collider_set_material(world: number, collider: bigint, material: bigint, error: number): number;
  /** The body's mass follows, unless it was given. Wakes the body and its island.   @param density kg/m^3, [0, 1e9]
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_collider_set_density(world: number, collider: bigint, density: number, error: number): number;
  /** Move a shape on its body; the body's mass follows. What is remembered of its contacts is dropped.
   *  @param position [3] m, body frame: origin of the shape; each within 1e15   @param orientation [4] x, y, z, w, shape
   *  to body
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_collider_set_pose(world: number, collider: bigint, position: number, orientation: number, error: number): number;
  /** Let a collider's surface move though the collider stays: a conveyor belt, a turntable, a track. Friction then brings
   *  what touches it to the velocity of the surface,
   *    v_body(x) + R (linear + angular x (R^T (x - p))),   the part of it in the plane of the contact,
   *  with R the orientation and p the origin of the shape in the world: axes and origin are the shape's own, so that a
   *  belt turns with its body. Nothing moves but by friction: a surface without friction moves nothing. On a body that
   *  moves it drives that body. Wakes what a change of the collider's filter wakes; what touches a surface that moves
   *  does not fall asleep.
   *  @param linear  [3] m/s, axes of the shape; 0 when a collider is created
   *  @param angular [3] rad/s, axes of the shape, about its origin
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (beyond 1e6 m/s or rad/s); BUSY; REENTRANT;
   *          OUT_OF_MEMORY */
  carom_collider_set_surface_velocity(world: number, collider: bigint, linear: number, angular: number, error: number): number;
  /** @param linear, angular out: [3], as they were set   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_collider_get_surface_velocity(world: number, collider: bigint, linear: number, angular: number, error: number): number;
  /** Number of bodies, and their handles in creation order of the slots.
   *  @param handles [capacity] or NULL   @param count out: how many there are
   *  @status OK; NULL_ARGUMENT; BUSY */
  carom_world_get_bodies(world: number, handles: number, capacity: bigint, count: number, error: number): number;
  /** Read one field of n bodies.
   *  @param handles [n], or NULL for all bodies in the order of carom_world_get_bodies() (n must be their number)
   *  @param dst     n records of the field's scalars, `stride` bytes apart
   *  @param stride  bytes from one record to the next; 0: tightly packed
   *  @param field   CAROM_FIELD_*
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride);
   *  BUSY */
  carom_world_read(world: number, field: number, scalar: number, handles: number, n: bigint, dst: number, stride: bigint, error: number): number;
  /** Write one field of n bodies; all values are validated before the first is written. Arguments as carom_world_read().
   *  @param src n records of the field's scalars, `stride` bytes apart
   *  @status as carom_world_read(); UNSUPPORTED (read-only field); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; REENTRANT */
  carom_world_write(world: number, field: number, scalar: number, handles: number, n: bigint, src: number, stride: bigint, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_cast_desc_init(desc: number, struct_size: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_motion_init(motion: number, struct_size: number): number;
  /** Cast the ray origin + t direction, 0 <= t <= max, against a shape.
   *  @param position, orientation  of the shape: [3] m, [4] x, y, z, w
   *  @param origin [3] m   @param direction [3] m per unit of t, any length; zero asks whether the origin is inside
   *  @param max    >= 0, may be infinite
   *  @param desc   may be NULL: defaults     @param result struct_size set by the caller
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED */
  carom_ray_cast(engine: number, shape: bigint, position: number, orientation: number, origin: number, direction: number, max: number, desc: number, result: number, error: number): number;
  /** Move shape A along a straight line, without turning it, until it touches B.
   *  @param motion [3] m, of A; times are fractions of it. If B moves too: the difference of the two
   *  @param desc   may be NULL: defaults     @param result struct_size set by the caller
   *  @param position_* [3] m, world   @param orientation_* [4] x, y, z, w
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
   *          half-spaces) */
  carom_shape_cast(engine: number, shape_a: bigint, position_a: number, orientation_a: number, motion: number, shape_b: bigint, position_b: number, orientation_b: number, desc: number, result: number, error: number): number;
  /** First contact of two shapes that both travel and turn, within a duration. UNDECIDED: the cap came first, nothing
   *  touches before `lower`.
   *  @param motion_*  struct_size set by carom_motion_init()   @param duration s, 0 to 1e9
   *  @param desc   may be NULL: defaults     @param result struct_size set by the caller; times in s
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
   *          UNSUPPORTED (two half-spaces, or one that turns) */
  carom_shape_time_of_impact(engine: number, shape_a: bigint, motion_a: number, shape_b: bigint, motion_b: number, duration: number, desc: number, result: number, error: number): number;
  /** Do two shapes overlap (or come nearer than desc->target)? Cheaper than their distance, with a proof of yes or no.
   *  @param desc   may be NULL: defaults; tolerance is not used   @param result struct_size set by the caller
   *  @param position_* [3] m, world   @param orientation_* [4] x, y, z, w
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
   *          half-spaces) */
  carom_shape_overlap(engine: number, shape_a: bigint, position_a: number, orientation_a: number, shape_b: bigint, position_b: number, orientation_b: number, desc: number, result: number, error: number): number;
  /** Cast many rays against one or more shapes: the first hit of each. A bad ray, or one for which a support function
   *  misbehaves (status CAROM_QUERY_FAULT, that of `shape`), spoils no other. Nothing is allocated per ray.
   *  @param shapes [shape_count]   @param positions [3 shape_count] m   @param orientations [4 shape_count] x, y, z, w
   *  @param desc   may be NULL: defaults
   *  @param shape_count number of shapes
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; UNSUPPORTED;
   *          BUFFER_TOO_SMALL (a stride); LIMIT (2^32 - 1 shapes); OUT_OF_MEMORY */
  carom_rays_cast(engine: number, shapes: number, positions: number, orientations: number, shape_count: bigint, rays: number, desc: number, hits: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_character_desc_init(desc: number, struct_size: number): number;
  /** At the origin, in the air, without a shape.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_character_init(character: number, struct_size: number): number;
  /** Give it a shape, or another one: to crouch, to stand up. The lowest point stays where it is, so the origin moves
   *  along `up`. With `fits` the new shape is looked at first. If something is within half the skin of it, `fits` becomes
   *  0 and nothing changes. Call it again after `up` has changed against the shape.
   *  @param shape convex, of the world's engine: most take a capsule
   *  @param desc may be NULL: defaults
   *  @param character its shape, position, foot, head and reach change
   *  @param fits out: 1 or 0; NULL: it is changed whatever is there, and a later move brings it out
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a half-space, scenery; unknown bits); UNKNOWN_ENUM; *_HANDLE;
   *          NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; PLUGIN_INVALID; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader */
  carom_character_set_shape(engine: number, world: number, desc: number, character: number, shape: bigint, fits: number, error: number): number;
  /** Move a character by dt. In this order: it follows the ground that it stood on, leaves what it overlaps, then walks,
   *  jumps or falls.
   *  
   *  On firm ground its velocity across `up` follows `walk`, on slopes and steps, too. In the air and on steep ground it
   *  follows `walk` plus the velocity of the ground that it left. Paths in the air are exact parabolas, so where it lands
   *  does not depend on dt beyond one dt's way. On open ground a move takes three queries, in a corner about ten. It
   *  allocates nothing but what queries do.
   *  @param desc may be NULL: defaults
   *  @param character all but shape, foot, head and reach may change
   *  @param walk [3] m/s, world, each within 1e6: what it is to move at, relative to the ground; the part along `up`
   *         counts only with CAROM_CHARACTER_FLIES
   *  @param jump m/s, [0, 1e6], along `up`: on firm ground it takes off at this speed, and takes the velocity of the
   *         ground with it; else, and with 0, it does not
   *  @param dt s, [0, 1]
   *  @accuracy stands `skin` and 2 % from surfaces, within 1e-5 m or 1e-6 of its size
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits, reserved); UNKNOWN_ENUM; *_HANDLE (desc->body;
   *          character->shape: call carom_character_set_shape() first); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
   *          REENTRANT; OUT_OF_MEMORY
   *  @thread reader */
  carom_character_move(world: number, desc: number, character: number, walk: number, jump: number, dt: number, error: number): number;
  /** Push what the last move met, and press on what the character stands on, as forces of the next step. A dynamic body
   *  in its way gets the force that would bring it to the character's speed within dt, push_force at most. One under
   *  firm feet gets mass * gravity. Bodies that are gone are left out.
   *  @param desc may be NULL: defaults   @param character as the last move left it   @param dt s, [1e-9, 1], of the next
   *  step
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
   *          BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_character_push(world: number, desc: number, character: number, dt: number, error: number): number;
  /** Let a kinematic body of the host's follow the character, so that other bodies and characters touch it. It gets the
   *  velocity that brings it to the character's place in the next step of dt. Where that is over 1 m away, or the
   *  character has turned, it is placed there at once, at rest. Give the body the character's shape, and name it in
   *  desc->body.
   *  @param desc with a body   @param dt s, [1e-9, 1], of the next step
   *  @param character as the last move left it
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE
   *          (also: a body that is not kinematic); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_character_move_body(world: number, desc: number, character: number, dt: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM (dial >= CAROM_DIAL_COUNT of this library) */
  carom_dial_get_info(dial: number, info: number, error: number): number;
  /** Number of dials this library has.   @status OK; NULL_ARGUMENT */
  carom_dial_get_count(count: number): number;
  /** @param name as in carom_dial_info.name
   *  @status OK; NULL_ARGUMENT; NOT_FOUND; READ_ONLY (this is a constant, not a dial) */
  carom_dial_find(name: number, dial: number, error: number): number;
  /** Number of constants this library has.   @status OK; NULL_ARGUMENT */
  carom_constant_get_count(count: number): number;
  /** @param constant from 0   @param info out
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM (constant >= carom_constant_get_count()) */
  carom_constant_get_info(constant: number, info: number, error: number): number;
  /** Static name of a preset ("balanced"), or "?".
   *  @param preset CAROM_PRESET_* */
  carom_preset_name(preset: number): number;
  /** What a preset sets a dial to. Presets speak of dials that trade accuracy for time, and all of the same ones; how a
   *  world finds pairs, what sleeps, and what a host chose for its look they leave alone.
   *  @param preset CAROM_PRESET_*   @param dial CAROM_DIAL_*   @param value out
   *  @param value what the preset sets the dial to
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND (presets leave this dial alone) */
  carom_preset_get_dial(preset: number, dial: number, value: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_draw_desc_init(desc: number, struct_size: number): number;
  /** All lines of the kinds that desc names, kind by kind in the order of the bits. Shapes whose support function fails
   *  are left out, and so are bodies in quarantine. The same world gives the same lines.
   *  @param desc     NULL: defaults
   *  @param dst      [capacity] elements `stride` bytes apart (0: sizeof(carom_draw_line)), or NULL to count
   *  @param count    out: lines there are; more than capacity: the first `capacity` of them were written
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a bit of what, reserved); UNKNOWN_ENUM; NOT_FINITE,
   *          OUT_OF_RANGE (scale); BUFFER_TOO_SMALL (stride); BUSY; REENTRANT; OUT_OF_MEMORY
   *  @thread reader */
  carom_world_draw(world: number, desc: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_engine_desc_init(desc: number, struct_size: number): number;
  /** Make an engine. @param desc may be NULL: defaults.   @owns the caller: carom_engine_destroy()
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; LIMIT (65,535 engines and worlds in all); OUT_OF_MEMORY */
  carom_engine_create(desc: number, engine: number, error: number): number;
  /** Destroy an engine; its worlds, batches and devices must be gone.   @status OK; NULL_ARGUMENT; IN_USE (destroy its worlds, batches and devices first);
   *  REENTRANT   @thread writer: no other call may use the engine */
  carom_engine_destroy(engine: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_jobs_desc_init(desc: number, struct_size: number): number;
  /** Say which threads share the work of steps in the engine's worlds, before the first of them is made. Support
   *  functions are then called, and the allocator may be, on those threads; those of HOST_THREAD plugins are still called
   *  on the stepping one.
   *  @param desc may be NULL: the stepping thread alone
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; OUT_OF_RANGE; IN_USE (worlds, batches or devices are
   *  alive, or carom_pairs_distance() is under way); LIMIT (the system has no more threads); OUT_OF_MEMORY; REENTRANT */
  carom_engine_set_jobs(engine: number, desc: number, error: number): number;
  /** Load a shape plugin from a shared object. @param path absolute.
   *  The plugin is checked before anything is called, then by its support points in 256 directions, with parameters that
   *  the bounds allow. Loading the same path twice is ALREADY_EXISTS.
   *  @status OK; NULL_ARGUMENT; PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; ALREADY_EXISTS; OUT_OF_MEMORY */
  carom_plugin_load(engine: number, path: number, plugin: number, error: number): number;
  /** Register a plugin by pointer: static linking, WebAssembly, or a shape written in the host's language.
   *  The struct and all it points to must outlive the engine.   @status as carom_plugin_load() */
  carom_plugin_register(engine: number, description: number, plugin: number, error: number): number;
  /** Register the plugins of plugins/ that are linked into the library: in an archive (carom::carom_static), in
   *  WebAssembly, and where it was built with CAROM_LINK_SHAPES. Those that the engine has already are left as they are.
   *  @status OK; NULL_ARGUMENT; UNSUPPORTED (none is linked in: load files, or name shapes); LIMIT; OUT_OF_MEMORY */
  carom_plugins_register_standard(engine: number, error: number): number;
  /** Forget a plugin (logically: the code stays mapped).   @status OK; NULL_ARGUMENT; IN_USE (shapes of it live);
   *  *_HANDLE; REENTRANT */
  carom_plugin_unload(engine: number, plugin: bigint, error: number): number;
  /** Find a loaded plugin by its id.
   *  @param id as in carom_shape_plugin.id
   *  @status OK; NULL_ARGUMENT; NOT_FOUND (load it first) */
  carom_plugin_find(engine: number, id: number, plugin: number, error: number): number;
  /** The plugin's own description, as its author compiled it: documentation, declarations, function. Only fields within
   *  its struct_size are there. Valid while the engine lives.
   *  @status OK; NULL_ARGUMENT; *_HANDLE */
  carom_plugin_describe(engine: number, plugin: bigint, description: number, error: number): number;
  /** Say what to collect from the next step on; nothing at first. Contacts and overlaps that there are already begin in
   *  that step.
   *  @param kinds     CAROM_EVENTS_* bits; 0: nothing
   *  @param hit_speed m/s, [0, 1e9]: contacts that approach faster are hits
   *  @status OK; NULL_ARGUMENT; UNSUPPORTED (kinds); NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_world_collect_events(world: number, kinds: number, hit_speed: number, error: number): number;
  /** Copy them out, by the slots of the two colliders; of one pair END before BEGIN before HIT.
   *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
   *  @param stride   sizeof(carom_contact_event) as the caller knows it
   *  @param count    out: how many there are (may exceed capacity; capacity are written)
   *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
  carom_world_get_contact_events(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** Arguments as carom_world_get_contact_events(). */
  carom_world_get_sensor_events(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** By the slots of the bodies; arguments as carom_world_get_contact_events(). */
  carom_world_get_sleep_events(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** By the slots of the joints; arguments as carom_world_get_contact_events(). */
  carom_world_get_joint_events(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** As they happened; arguments as carom_world_get_contact_events(). */
  carom_world_get_fault_events(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** Two colliders of different bodies touch if each one's mask has a bit of the other's category; unless both are of one
   *  group other than 0: then they do if it is positive and do not if it is negative, whatever their masks say.
   *  @param category, mask  any bits   @param group 0: none
   *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_collider_set_filter(world: number, collider: bigint, category: bigint, mask: bigint, group: number, error: number): number;
  /** @param category, mask, group  out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_collider_get_filter(world: number, collider: bigint, category: number, mask: number, group: number, error: number): number;
  /** The same for all colliders that a body has now.   @status as carom_collider_set_filter() */
  carom_body_set_filter(world: number, body: bigint, category: bigint, mask: bigint, group: number, error: number): number;
  /** Let two bodies make no contacts with each other, whatever their filters say, or restore their contacts. Calls are
   *  counted: undo each one. Undoing more does nothing.
   *  @param ignored 1 or 0
   *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (ignored; a body and itself); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_body_ignore_collision(world: number, body_a: bigint, body_b: bigint, ignored: number, error: number): number;
  /** Make a collider a sensor: it reports what overlaps it (carom_world_get_sensor_events()) and is touched by nothing.
   *  It obeys its filter, does not sense other sensors, and static sensors do not sense static bodies. Its density counts
   *  as before.
   *  @param sensor 1 or 0
   *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (sensor); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_collider_set_sensor(world: number, collider: bigint, sensor: number, error: number): number;
  /** @param sensor out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_collider_is_sensor(world: number, collider: bigint, sensor: number, error: number): number;
  /** Add a force that acts at a point, for the next step only: carom_body_add_force() with its torque about the centre of
   *  mass as the body stands now.
   *  @param force [3] N, world   @param point [3] m, world
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT */
  carom_body_add_force_at(world: number, body: bigint, force: number, point: number, error: number): number;
  /** How air resists a body: F = -(linear + quadratic |u|) u at its centre, u its velocity relative to the air. Without
   *  other forces speeds follow the closed form at any step. (carom_body_desc.linear_damping is relative to the world,
   *  not to the air, and to mass.)
   *  @param linear    kg/s, [0, 1e12]: slow, small bodies (6 pi eta r of a ball); 0 when a body is created
   *  @param quadratic kg/m, [0, 1e12]: fast, large ones, rho c_d A / 2 (a ball of 0.1 m in air: 0.0087); 0 likewise
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_body_set_drag(world: number, body: bigint, linear: number, quadratic: number, error: number): number;
  /** @param linear, quadratic out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_drag(world: number, body: bigint, linear: number, quadratic: number, error: number): number;
  /** How the air moves; it reaches bodies through their drag alone.
   *  @param velocity [3] m/s, |each| <= 1e6; 0 when a world is created
   *  @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_world_set_wind(world: number, velocity: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; BUSY */
  carom_world_get_wind(world: number, velocity: number, error: number): number;
  /** Static name of a kind of field ("uniform"), or "?".
   *  @param kind CAROM_FORCE_FIELD_* */
  carom_force_field_name(kind: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_force_field_desc_init(desc: number, struct_size: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
   *          REENTRANT; LIMIT; OUT_OF_MEMORY */
  carom_force_field_create(world: number, desc: number, field: number, error: number): number;
  /** Change a field in place: move it, turn it up.   @status as carom_force_field_create(); *_HANDLE */
  carom_force_field_update(world: number, field: bigint, desc: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
  carom_force_field_get(world: number, field: bigint, desc: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
  carom_force_field_destroy(world: number, field: bigint, error: number): number;
  /** Which fields a body feels. A field with a bit that few bodies have costs those few.
   *  @param mask 1 when a body is created; 0: none
   *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_body_set_force_field_mask(world: number, body: bigint, mask: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_body_get_force_field_mask(world: number, body: bigint, mask: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_spring_desc_init(desc: number, struct_size: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT;
   *          OUT_OF_MEMORY */
  carom_spring_create(world: number, desc: number, spring: number, error: number): number;
  /** Change what a spring is like; its ends stay.
   *  @param rest m   @param stiffness N/m   @param damping N s/m; ranges as in carom_spring_desc
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_spring_update(world: number, spring: bigint, rest: number, stiffness: number, damping: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
  carom_spring_get(world: number, spring: bigint, desc: number, error: number): number;
  /** @param length out: m, as its ends stand   @param force out: N, above 0 it pulls them together, as it is set
   *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_spring_get_state(world: number, spring: bigint, length: number, force: number, error: number): number;
  /** Goes with its bodies, too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
  carom_spring_destroy(world: number, spring: bigint, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_water_init(water: number, struct_size: number): number;
  /** @param water NULL: none, as a world is created
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_world_set_water(world: number, water: number, error: number): number;
  /** @param water out   @param present out: 1 or 0; if 0, water is filled with defaults
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
  carom_world_get_water(world: number, water: number, present: number, error: number): number;
  /** Static name of a kind of joint ("hinge", "six_axis"), or "?". Scene files and bindings have these names.
   *  @param kind CAROM_JOINT_* */
  carom_joint_kind_name(kind: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_joint_desc_init(desc: number, struct_size: number): number;
  /** Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_joint_limit_init(limit: number, struct_size: number): number;
  /** Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_joint_motor_init(motor: number, struct_size: number): number;
  /** Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_joint_spring_init(spring: number, struct_size: number): number;
  /** Ratio 1, anchors at the origin, the rope as long as it is.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_joint_transmission_init(transmission: number, struct_size: number): number;
  /** The follower goes as far as the leader.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_joint_coupling_init(coupling: number, struct_size: number): number;
  /** Free, without drive and spring, `max_force` and limits as large as may be.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_joint_axis_init(axis: number, struct_size: number): number;
  /** No drive, the target as the frames are when they agree.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_joint_orientation_drive_init(drive: number, struct_size: number): number;
  /** Join two bodies, or one and the world. Their islands wake. A body that is destroyed takes its joints with it.
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a newer field; solver severity; a coupling, which
   *          carom_joint_couple() makes); UNKNOWN_ENUM; *_HANDLE; NOT_UNIT;
   *          NOT_FINITE; OUT_OF_RANGE (also: a body joined to itself, none that is dynamic, or places 1e15 m from a
   *          body's origin or 8e15 m from each other, as of bodies that the next step will quarantine); BUSY; REENTRANT;
   *          LIMIT; OUT_OF_MEMORY */
  carom_joint_create(world: number, desc: number, joint: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
  carom_joint_destroy(world: number, joint: bigint, error: number): number;
  /** @param desc out: as it was made, with frames in body coordinates
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
  carom_joint_get(world: number, joint: bigint, desc: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
  carom_joint_get_state(world: number, joint: bigint, state: number, error: number): number;
  /** Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
   *  @param coordinate CAROM_COORDINATE_*
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
   *          limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_joint_set_limit(world: number, joint: bigint, coordinate: number, limit: number, error: number): number;
  /** Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
   *  @param coordinate CAROM_COORDINATE_*
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
   *          limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_joint_set_motor(world: number, joint: bigint, coordinate: number, motor: number, error: number): number;
  /** Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
   *  @param coordinate CAROM_COORDINATE_*
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
   *          limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_joint_set_spring(world: number, joint: bigint, coordinate: number, spring: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
  carom_joint_get_limit(world: number, joint: bigint, coordinate: number, limit: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
  carom_joint_get_motor(world: number, joint: bigint, coordinate: number, motor: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
  carom_joint_get_spring(world: number, joint: bigint, coordinate: number, spring: number, error: number): number;
  /** Say what a pulley's rope runs over, or how a gear's wheels turn; the bodies wake. What a limit, motor or spring on a
   *  pulley's distance requires is in metres of the rope. A gear holds from where its wheels stand now, as often as they
   *  may turn: turns are counted while it steps, as long as a wheel's speed changes by less than half a turn a substep in
   *  one; a pose that the host sets between steps is no turn.
   *  Accuracy: second order in the substep, as all joints; the rope's length errs by what joint_frequency leaves, and
   *  under the direct solver by 1e-9 m; a gear's angles err by rounding, a few 1e-16 rad a substep. Oracle:
   *  tests/oracle/test_pulley_gear.
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is neither pulley nor gear; a newer field); *_HANDLE;
   *          NOT_FINITE; OUT_OF_RANGE (also: a ratio of 0; 1 is what the init function gives); BUSY; REENTRANT */
  carom_joint_set_transmission(world: number, joint: bigint, transmission: number, error: number): number;
  /** @param transmission out: as it was set, with its length; ratio 0: not yet
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
  carom_joint_get_transmission(world: number, joint: bigint, transmission: number, error: number): number;
  /** Couple two joints: makes a joint of kind CAROM_JOINT_COUPLING, whose bodies are one of each joint's. Their islands
   *  wake. It goes with either joint that is destroyed, and holds nothing once one of them is broken. What it is off by,
   *  as it is made or because a host moves joints, is led back. It has no frames and never breaks itself.
   *  carom_joint_state of it: `gap` or `angle` is how far the follower is off; force is 0, torque[0] the N or N m along the
   *  follower's coordinate that it pushes with, mean over the last step.
   *  Accuracy: as of locks: second order in the substep, 1e-9 m or rad under the direct solver, rounding where dial
   *  joint_order moves it. Oracle: tests/oracle/test_couplings.
   *  @param joint out: the coupling
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a joint that is neither hinge nor slider; a newer field; a
   *          reserved one; solver severity); *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a joint that follows itself); BUSY;
   *          REENTRANT; LIMIT; OUT_OF_MEMORY */
  carom_joint_couple(world: number, coupling: number, joint: number, error: number): number;
  /** Give a coupling another polynomial; its bodies wake.
   *  @param coupling its follower and leader are CAROM_NULL_HANDLE or as they were, its user is not read
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is no coupling; other joints than its own; a newer
   *          field; a reserved one); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_joint_set_coupling(world: number, joint: bigint, coupling: number, error: number): number;
  /** @param coupling out: as it was made
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
  carom_joint_get_coupling(world: number, joint: bigint, coupling: number, error: number): number;
  /** Say what one axis of a six-axis joint, a hinge or a slider does; the bodies wake. Effect joint_limits has its limits, joint_motors its
   *  drives; springs and locks are of the joint. A target, a lock's place or a limit may be set anew before each step.
   *  Accuracy: what is locked errs in second order of the substep h, under the direct solver by 1e-9 m or rad. With w the
   *  frequency and b half the damping per mass: springs, stops and drives to a position swing late by w h / 2 of their
   *  amplitude and fade slower by b h of their rate; at rest they sag by load / stiffness, to rounding where one joint
   *  bears all, in first order where soft_step sweeps over several. A drive to a velocity holds that of the middle of a
   *  substep under the direct solver, and one with a damping alone does under any: what a step ends with differs by what
   *  the load does in h / 2. Forces of drives are met to rounding. A speed limit holds to 1e-9 under the
   *  direct solver, where one joint bears all to rounding under others. Oracle: tests/oracle/test_six_axis, test_six_axis_scenes, test_armature,
   *  test_axis_limits.
   *  @param axis CAROM_AXIS_*
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint has no such axis of its own; a newer field);
   *          *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_joint_set_axis(world: number, joint: bigint, axis: number, desc: number, error: number): number;
  /** @param axis CAROM_AXIS_*   @param desc out: as it was set
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
  carom_joint_get_axis(world: number, joint: bigint, axis: number, desc: number, error: number): number;
  /** Drive a ball, or a six-axis joint, to an orientation or to an angular velocity; the bodies wake. Of effect
   *  joint_motors. Accuracy: first order in the substep of where it is, as springs with dampers are; where nothing pulls
   *  it ends at the target to rounding. Oracle: tests/oracle/test_six_axis.
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint is neither ball nor six-axis; a newer
   *          field; a reserved one); *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_joint_set_orientation_drive(world: number, joint: bigint, drive: number, error: number): number;
  /** @param drive out: as it was set
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
  carom_joint_get_orientation_drive(world: number, joint: bigint, drive: number, error: number): number;
  /** How many scalars a record of a field has.
   *  @param field CAROM_JOINT_BULK_*   @param width out: of a record   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM */
  carom_joint_bulk_width(field: number, width: number): number;
  /** Read one field of n joints, as carom_world_read() does of bodies.
   *  A rate of what has no direction (points or axes that agree) is the one at which it begins to grow.
   *  Accuracy: rounding of poses and velocities; of a twist times 1 / cos(swing / 2). An effort errs in first order of the
   *  step, by how far the axis turned in it. Oracle: tests/abi/test_joint_bulk.
   *  @param field   CAROM_JOINT_BULK_*   @param scalar CAROM_SCALAR_*
   *  @param joints  [n], or NULL for all in the order of carom_world_get_joints() (n must be their number)
   *  @param dst     n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); UNSUPPORTED (a kind without the field);
   *  OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride); BUSY */
  carom_world_read_joints(world: number, field: number, scalar: number, joints: number, n: bigint, dst: number, stride: bigint, error: number): number;
  /** Write one field of n joints; all values are validated before the first is written, joints of a tree are moved as one.
   *  Accuracy of places: rounding of poses, to 1e-15 of a chain's length a joint. Oracle: tests/oracle/test_joint_moves. Modes, units of gains and what is
   *  enabled stay as they are, where the record does not have them. Bodies of joints that this changes wake. Arguments as carom_world_read_joints().
   *  @param src n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
   *  @status as carom_world_read_joints(); UNSUPPORTED (also: a field that is read only; a joint of a loop, a broken one,
   *  one between bodies that forces do not move); NOT_FINITE; NOT_UNIT;
   *  OUT_OF_RANGE; REENTRANT */
  carom_world_write_joints(world: number, field: number, scalar: number, joints: number, n: bigint, src: number, stride: bigint, error: number): number;
  /** Number of joints, and their handles in creation order of the slots.
   *  @param joints [capacity] or NULL   @param count out: how many there are
   *  @status OK; NULL_ARGUMENT; BUSY */
  carom_world_get_joints(world: number, joints: number, capacity: bigint, count: number, error: number): number;
  /** Keep a ledger from now on, anew if one is kept; or none. Off in a new world.
   *  @param on  0 or 1
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM (on); BUSY; REENTRANT; OUT_OF_MEMORY: as it was */
  carom_world_enable_ledger(world: number, on: number, error: number): number;
  /** Copy out all causes, in the order above; none of a world that keeps no ledger.
   *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
   *  @param stride   sizeof(carom_ledger_entry) as the caller knows it
   *  @param count    out: how many there are (may exceed capacity; capacity are written)
   *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
  carom_world_get_ledger(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
  carom_world_get_ledger_state(world: number, state: number, error: number): number;
  /** Signed distance of each pair, on the engine's threads (carom_engine_set_jobs()). Each result has the bits that
   *  carom_shape_distance() gives for its pair, for any number of threads. All pairs are checked before the first result
   *  is written, and a message names the pair that is wrong. A pair whose support function misbehaves says so in its
   *  status (CAROM_QUERY_FAULT), and spoils no other. Nothing is allocated per pair.
   *  @param desc   may be NULL: defaults
   *  @param dst    out, [pairs->count]; no array of pairs
   *  @param stride sizeof(carom_distance) as the caller knows it; an older, shorter one gets its beginning. struct_size is
   *                written, too
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; UNSUPPORTED (a
   *          pair of half-spaces or sceneries); BUFFER_TOO_SMALL (a stride); OUT_OF_MEMORY; INTERNAL (a callback left its
   *          thread: some results were written)
   *  @since 0.9 */
  carom_pairs_distance(engine: number, pairs: number, desc: number, dst: number, stride: bigint, error: number): number;
  /** Open a device. Its arithmetic is tried, and it is refused where a number is rounded otherwise than on the host.
   *  @param index  among all devices of all platforms, in the order in which the system has them; 0 is the first
   *  @param device out: to be destroyed before the engine   @owns the caller: carom_device_destroy()
   *  @status OK; NULL_ARGUMENT; NOT_FOUND (no OpenCL, or no such device: the message says how many there are); UNSUPPORTED
   *          (it has no double precision, or rounds otherwise); OUT_OF_MEMORY
   *  @since 0.9 */
  carom_device_create(engine: number, index: number, device: number, error: number): number;
  /** @param device from carom_device_create()   @status OK; NULL_ARGUMENT; BUSY; REENTRANT   @since 0.9 */
  carom_device_destroy(device: number, error: number): number;
  /** @param device from carom_device_create()   @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY   @since 0.9 */
  carom_device_get_info(device: number, info: number, error: number): number;
  /** As carom_pairs_distance(), on a device: each result has the same bits. Shapes are of the device's engine.
   *  @param device from carom_device_create()
   *  @param desc   may be NULL: defaults
   *  @param dst    out, [pairs->count]; no array of pairs
   *  @param stride as carom_pairs_distance()
   *  @status as carom_pairs_distance(); UNSUPPORTED (a shape that a device cannot ask; CAROM_SIMPLEX_JOHNSON and routines of
   *          pairs, which devices have not; a driver that failed: some results may be written); BUSY; REENTRANT
   *  @since 0.9 */
  carom_device_pairs_distance(device: number, pairs: number, desc: number, dst: number, stride: bigint, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_particles_desc_init(desc: number, struct_size: number): number;
  /** Make an empty set.
   *  @param desc may be NULL: defaults
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY */
  carom_particles_create(world: number, desc: number, set: number, error: number): number;
  /** Its particles too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
  carom_particles_destroy(world: number, set: bigint, error: number): number;
  /** @param desc out: as it was made or updated; capacity: particles there is memory for
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
  carom_particles_get(world: number, set: bigint, desc: number, error: number): number;
  /** Change what they have in common; particles that are there keep their mass.
   *  @param desc may be NULL: defaults; capacity: memory for so many in all
   *  @status as carom_particles_create(); *_HANDLE */
  carom_particles_update(world: number, set: bigint, desc: number, error: number): number;
  /** @param count out: particles in the set   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_particles_get_count(world: number, set: bigint, count: number, error: number): number;
  /** Add n particles at the end; all values are checked before the first is added.
   *  @param scalar          CAROM_SCALAR_*, of both arrays
   *  @param positions       [n] m, world, three scalars each, within 1e15 m of the origin
   *  @param position_stride bytes from one to the next; 0: tightly packed
   *  @param velocities      [n] m/s, world, likewise, at most 1e9 m/s; NULL: at rest
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUFFER_TOO_SMALL (stride); LIMIT (2^31
   *          - 1 in a set); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_particles_add(world: number, set: bigint, n: bigint, scalar: number, positions: number, position_stride: bigint, velocities: number, velocity_stride: bigint, error: number): number;
  /** Remove n particles. The others keep their order, so each moves up by as many as went before it.
   *  @param indices [n] ascending, each once; NULL: all of them (n must be their number)
   *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (an index, their order, n); BUSY; REENTRANT */
  carom_particles_remove(world: number, set: bigint, indices: number, n: bigint, error: number): number;
  /** Read one field of n particles.
   *  @param field   CAROM_FIELD_POSITION, LINEAR_VELOCITY or MASS
   *  @param indices [n] in any order, or NULL: all of them (n must be their number)
   *  @param dst     n records of the field's scalars, `stride` bytes apart
   *  @param stride  bytes from one record to the next; 0: tightly packed
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; UNSUPPORTED (a field that particles do not have); *_HANDLE; OUT_OF_RANGE
   *          (an index, n); BUFFER_TOO_SMALL (stride); BUSY */
  carom_particles_read(world: number, set: bigint, field: number, scalar: number, indices: number, n: bigint, dst: number, stride: bigint, error: number): number;
  /** Write one field of n particles; all values are checked before the first is written, bounds as carom_particles_add(),
   *  masses as carom_particles_desc. Arguments as carom_particles_read(); where an index comes twice, the last counts.
   *  @param src n records of the field's scalars, `stride` bytes apart
   *  @status as carom_particles_read(); NOT_FINITE; OUT_OF_RANGE; REENTRANT; OUT_OF_MEMORY */
  carom_particles_write(world: number, set: bigint, field: number, scalar: number, indices: number, n: bigint, src: number, stride: bigint, error: number): number;
  /** A particle that has come further than 1e15 m or become faster than 1e9 m/s is put in quarantine: it is held still
   *  where it is and counts in no energy, until a host writes its position or removes it. carom_world_get_faults()
   *  reports the first of each set and step (CAROM_FAULT_PARTICLE_STATE), this call all that are held now, ascending.
   *  @param indices [capacity] out; may be NULL if capacity is 0
   *  @param count   out: how many there are (may exceed capacity; capacity are written)
   *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
  carom_particles_get_quarantined(world: number, set: bigint, indices: number, capacity: bigint, count: number, error: number): number;
  /** Number of sets, and their handles in creation order of the slots.
   *  @param sets [capacity] or NULL   @param count out: how many there are
   *  @status OK; NULL_ARGUMENT; BUSY */
  carom_world_get_particles(world: number, sets: number, capacity: bigint, count: number, error: number): number;
  /** Static name of an effect ("gravity"), or "?". */
  carom_effect_name(effect: number): number;
  /** Forbid or force an effect from the next step on, for all bodies. Wakes all bodies. Forbidding one that the scene
   *  needs is allowed, and carom_world_get_plan() says so.
   *  @param effect CAROM_EFFECT_*   @param mode CAROM_MODE_*
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT */
  carom_world_set_effect(world: number, effect: number, mode: number, error: number): number;
  /** @param mode out   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY */
  carom_world_get_effect(world: number, effect: number, mode: number, error: number): number;
  /** The same for one body: its forces, its colliders, the contacts, joints and springs it is in. What is forbidden for
   *  the world is forbidden for it. Particles, events and the ledger are not a body's.
   *  @param mode CAROM_MODE_*
   *  @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; UNSUPPORTED (PARTICLES, EVENTS, LEDGER: use
   *          carom_world_set_effect()); BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_body_set_effect(world: number, body: bigint, effect: number, mode: number, error: number): number;
  /** @param mode out: of the body itself   @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; BUSY */
  carom_body_get_effect(world: number, body: bigint, effect: number, mode: number, error: number): number;
  /** Whether each force effect is timed by itself in carom_world_get_plan(), which costs two looks at the clock for each.
   *  @param on 1 or 0 (as a world is created)
   *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_world_time_effects(world: number, on: number, error: number): number;
  /** Copy out the plan of the last step: stages first, then effects. Before the first step nothing has run.
   *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
   *  @param stride   sizeof(carom_plan_line) as the caller knows it
   *  @param count    out: how many there are (may exceed capacity; capacity are written)
   *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
  carom_world_get_plan(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_distance_desc_init(desc: number, struct_size: number): number;
  /** Signed distance of two shapes.
   *  @param position_*     [3] m     @param orientation_* [4] x, y, z, w
   *  @param desc   may be NULL: defaults     @param result struct_size set by the caller
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM;
   *          UNSUPPORTED (two half-spaces) */
  carom_shape_distance(engine: number, shape_a: bigint, position_a: number, orientation_a: number, shape_b: bigint, position_b: number, orientation_b: number, desc: number, result: number, error: number): number;
  /** Record a world from now on, until carom_world_record_end() or until it is destroyed.
   *  @param flags CAROM_RECORD_*   @param write is kept, and called with `user`
   *  @status OK; NULL_ARGUMENT; UNSUPPORTED (flags); IN_USE (it is being recorded); WRITE_FAILED; BUSY; REENTRANT;
   *          OUT_OF_MEMORY */
  carom_world_record_begin(world: number, flags: number, write: number, user: number, error: number): number;
  /** Stop recording.
   *  @status OK; NULL_ARGUMENT; NOT_FOUND (it is not being recorded); WRITE_FAILED (`write` said so, now or before: the
   *          recording ends there); OUT_OF_MEMORY (likewise, for lack of memory); BUSY; REENTRANT */
  carom_world_record_end(world: number, error: number): number;
  /** Compare a world with a snapshot, between steps; of a world of the same structure. Reads only.
   *  @param difference its struct_size set by the caller
   *  @param bytes [size] of carom_world_save()   @param size number of bytes
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; CORRUPT, UNSUPPORTED, MISMATCH (as carom_world_restore()); BUSY; REENTRANT;
   *          OUT_OF_MEMORY   @thread reader */
  carom_world_compare(world: number, bytes: number, size: bigint, difference: number, error: number): number;
  /** @param residuals with its struct_size set; filled. Before the first step, and after a step without contacts, what
   *                   concerns them is 0.
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
   *  @accuracy rounding; effective masses are those along the normal
   *  @cost linear in contact points, joints and bodies */
  carom_world_get_residuals(world: number, residuals: number, error: number): number;
  /** Choose the dial `substeps` before each step so that steps take about `seconds`. What a substep costs is learnt from
   *  the last steps; if one took too long, substeps drop at once; if there is time left, one is added a step.
   *  Trajectories then depend on the machine's speed: two runs are not the same to the bit. Off (as a world is created)
   *  for lockstep and tests. The steps of a scene that is too expensive even with `fewest` take longer. A budget is the
   *  host's: no snapshot holds it, a copy begins without one, and a record (carom/record.h) has the substeps that it
   *  chose.
   *  @param seconds  s of wall clock a step, 0 < seconds <= 10; 0: off, the dial keeps its value
   *  @param fewest, most  substeps, 1 <= fewest <= most <= the dial's bound; ignored when off
   *  @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_world_set_budget(world: number, seconds: number, fewest: number, most: number, error: number): number;
  /** @param seconds, fewest, most  out: as set; 0 when off   @status OK; NULL_ARGUMENT; BUSY */
  carom_world_get_budget(world: number, seconds: number, fewest: number, most: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_mesh_desc_init(desc: number, struct_size: number): number;
  /** Make scenery of a mesh. All is copied.
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE (a count, an index, a vertex too far
   *          out, no triangle that has an area); LIMIT; OUT_OF_MEMORY */
  carom_shape_create_mesh(engine: number, desc: number, shape: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_height_field_desc_init(desc: number, struct_size: number): number;
  /** Make scenery of a height field. All is copied.
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE (an infinite height, a spacing); OUT_OF_RANGE (a
   *          count, a spacing that is not positive, a height too far out, nothing but holes); LIMIT; OUT_OF_MEMORY */
  carom_shape_create_height_field(engine: number, desc: number, shape: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE (set info->struct_size); *_HANDLE; UNSUPPORTED (a convex shape) */
  carom_shape_get_scenery_info(engine: number, shape: bigint, info: number, error: number): number;
  /** Copy out triangles of scenery, for drawing: each by its three corners, as its surface faces. Holes are left out.
   *  @param first   number of the first triangle wanted
   *  @param corners [9 count] m, shape frame, or NULL to count
   *  @param count   in: how many fit; out: how many were written (with NULL: how many there are from `first` on)
   *  @param next    out: the number of the triangle to go on from; the number of triangles when all have been seen
   *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (first); UNSUPPORTED (a convex shape) */
  carom_shape_get_triangles(engine: number, shape: bigint, first: bigint, corners: number, count: number, next: number, error: number): number;
  /** Make a shape. The parameters are copied. The support function is checked for these parameters (finite, repeatable,
   *  scale-free, samples in convex position), declarations are verified, and AABB and mass properties derived.
   *  @param params [count] doubles, meaning as the plugin documents
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (count or a bound; argument says which);
   *          PLUGIN_INVALID; DECLARATION_FALSE; OUT_OF_MEMORY */
  carom_shape_create(engine: number, plugin: bigint, params: number, count: bigint, shape: number, error: number): number;
  /** Make a shape by the name of its plugin: "box", or "carom.box", or the id of a plugin of yours. Plugins that the
   *  engine has come first, by id, then by the name of the file they were loaded from. Then a file NAME.so is looked for
   *  and loaded: in the folders of $CAROM_PLUGIN_PATH (absolute, separated by ':'; not in programs that run with raised
   *  privileges), beside the library, in the folder where plugins are installed. "half_space" is built in: normal x, y,
   *  z, offset.
   *  @param name 1 to 64 letters, digits, _, - and dots   @param params [count] as carom_shape_create()
   *  @status OK; NULL_ARGUMENT; NOT_FOUND (the message says where it was looked for); NOT_FINITE; OUT_OF_RANGE;
   *          PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; LIMIT; OUT_OF_MEMORY */
  carom_shape_create_named(engine: number, name: number, params: number, count: bigint, shape: number, error: number): number;
  /** The built-in half-space { x : normal . x <= offset } in the shape's own frame; unbounded, so static bodies only.
   *  @param normal [3] unit (within 1e-6)   @param offset m
   *  @status OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_MEMORY */
  carom_shape_create_half_space(engine: number, normal: number, offset: number, shape: number, error: number): number;
  /** Make the convex hull of shapes that the engine has, each placed and scaled, and all of it rounded by a radius. The
   *  same call makes
   *  - the sweep of a shape along a straight line, without turning: the shape at both ends. Where it turns as well, the hull
   *    of both ends leaves out what bulges between them: add poses in between;
   *  - a scaled shape: one part with a scale. A negative scale mirrors it;
   *  - a rounded shape: one part and a radius, by which it grows on all sides.
   *  Where all parts have corners only and the radius is 0, the hull is a polytope with exact mass and faces, and its
   *  corners are its parameters. Else its parameters are none and its mass is derived. A part cannot be destroyed before
   *  the hull.
   *  @param parts         [count] handles of convex shapes, the same one as often as wanted
   *  @param count         1 to 4096
   *  @param positions     [3 * count] m, frame of the hull; NULL: 0
   *  @param orientations  [4 * count] x, y, z, w, unit within 1e-6, part to hull; NULL: identity
   *  @param scales        [3 * count] along the axes of the part, of a size of 1e-6 to 1e6; NULL: 1
   *  @param radius        m, 0 or more
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (a part is a half-space or scenery);
   *          PLUGIN_INVALID; LIMIT (hulls of hulls more than 8 deep, or of more than 4096 parts in all); OUT_OF_MEMORY
   *  @since 0.9 */
  carom_shape_create_hull_of(engine: number, parts: number, count: bigint, positions: number, orientations: number, scales: number, radius: number, shape: number, error: number): number;
  /** What a hull of shapes is made of, as it was given. Of any other shape: no parts, radius 0.
   *  @param parts         [*count] or NULL: only count and radius are written
   *  @param positions     [3 * *count] m, or NULL   @param orientations [4 * *count] x, y, z, w, or NULL
   *  @param scales        [3 * *count] or NULL
   *  @param count         in: capacity in parts; out: number of parts
   *  @param radius        m, or NULL
   *  @status OK; NULL_ARGUMENT; *_HANDLE; BUFFER_TOO_SMALL (count says how many are needed)
   *  @since 0.9 */
  carom_shape_get_parts(engine: number, shape: bigint, parts: number, positions: number, orientations: number, scales: number, count: number, radius: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider, a hull of shapes, or a query on another thread, refers to
   *          it); REENTRANT */
  carom_shape_destroy(engine: number, shape: bigint, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE (set info->struct_size); *_HANDLE */
  carom_shape_get_info(engine: number, shape: bigint, info: number, error: number): number;
  /** Copy out the parameters. @param count in: capacity of params; out: number of parameters.
   *  @param params [count]
   *  @status OK; NULL_ARGUMENT; *_HANDLE; BUFFER_TOO_SMALL (count says how many are needed) */
  carom_shape_get_params(engine: number, shape: bigint, params: number, count: number, error: number): number;
  /** Support points of the whole shape, core radius included, for n directions at once.
   *  @param dirs [3n] nonzero, any length, shape frame   @param points [3n] m, shape frame
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a zero direction); UNSUPPORTED (half-space,
   *          scenery); PLUGIN_INVALID (the support function failed; the points before are written) */
  carom_shape_support(engine: number, shape: bigint, dirs: number, n: bigint, points: number, error: number): number;
  /** Write a snapshot, between steps. Reads only: other readers may be at work.
   *  @param flags    CAROM_SNAPSHOT_*
   *  @param buffer   [capacity] bytes, or NULL to get the size alone
   *  @param capacity bytes; 0 if buffer is NULL
   *  @param needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
   *  @status OK; NULL_ARGUMENT; UNSUPPORTED (flags); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader */
  carom_world_save(world: number, flags: number, buffer: number, capacity: bigint, needed: number, error: number): number;
  /** Put a snapshot back, between steps. All of it is read and checked, and all memory that it takes is there, before
   *  anything of the world changes.
   *  An empty world is rebuilt from a snapshot that is whole; `user` values come with it, a ledger
   *  begins anew. Shapes of the same plugin and numbers that the engine has are used, others made; they are the engine's,
   *  as if the host had made them (carom_collider_get() gives their handles). Any other world takes its state, as of one
   *  that is not whole.
   *  @param bytes [size], of any alignment   @param size as carom_world_save() gave it
   *  @status OK; NULL_ARGUMENT; CORRUPT (damaged, cut off, or no snapshot: the message says what); UNSUPPORTED (of a
   *  newer
   *          format); MISMATCH (of a world of another structure: the message names the kind that differs; or a plugin of
   *          that id and version makes other shapes than it did); NOT_FOUND (a shape plugin is not loaded: the message
   *          says id and version); LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY */
  carom_world_restore(world: number, bytes: number, size: bigint, error: number): number;
  /** Make a world of the same engine that is as this one is, and goes on as it does, bit for bit. Nothing of this one
   *  changes; other readers may be at work. Lists and residuals of its last step, and a ledger, the copy has none of.
   *  @param copy out: to be destroyed as any world
   *  @status OK; NULL_ARGUMENT; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader */
  carom_world_fork(world: number, copy: number, error: number): number;
  /** Handles of another world, as they are in this one: the same slots and generations. For what a host keeps of a world
   *  that it has forked, or of one that was saved whole, in another process too.
   *  @param handles    [n] of bodies, colliders, materials, joints, particles, fields, springs; 0 stays 0
   *  @param translated [n] out; may be `handles`. All of them or, where one is refused, none
   *  @status OK; NULL_ARGUMENT; INVALID_HANDLE; STALE_HANDLE; WRONG_KIND (of an engine: shapes are the same in all its
   *          worlds); BUSY; REENTRANT   @thread reader */
  carom_world_translate_handles(world: number, handles: number, n: bigint, translated: number, error: number): number;
  /** Copy out what the coordinates of a tree are.
   *  @param body     any dynamic body of the tree; its base, where nothing holds the tree
   *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
   *  @param stride   sizeof(carom_tree_coordinate) as the caller knows it
   *  @param count    out: how many there are (may exceed capacity; capacity are written)
   *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (the body is not moved by forces); UNSUPPORTED (no tree);
   *          BUFFER_TOO_SMALL (stride); BUSY; OUT_OF_MEMORY */
  carom_tree_get_coordinates(world: number, body: bigint, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** The speeds that a tree has now.
   *  Accuracy: rounding of the bodies' velocities. What joints do not leave free of these counts as nothing.
   *  @param speeds out, [n]   @param n how many coordinates there are
   *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY;
   *          OUT_OF_MEMORY */
  carom_tree_get_speeds(world: number, body: bigint, speeds: number, n: bigint, error: number): number;
  /** Inverse dynamics: the forces that give a tree these accelerations, at the present pose.
   *      forces = M accelerations + what gyroscopic and centrifugal terms and gravity ask
   *  With speeds of 0 and no accelerations these hold the tree against gravity.
   *  Accuracy: 1e-14 of the largest term, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
   *  @param speeds        [n] m/s and rad/s, or NULL: those of now
   *  @param accelerations [n] m/s^2 and rad/s^2, rates of the speeds, or NULL: 0
   *  @param forces        out, [n] N and N m
   *  @param n             how many coordinates there are
   *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE (also: forces that are beyond what numbers hold);
   *          OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY; OUT_OF_MEMORY */
  carom_tree_get_forces(world: number, body: bigint, speeds: number, accelerations: number, forces: number, n: bigint, error: number): number;
  /** The mass matrix of a tree at the present pose, symmetric and positive definite: with speeds v its energy of motion
   *  is v^T M v / 2. Where two axes of one joint agree M is singular.
   *  Accuracy: 1e-14 of the largest entry that a sum has, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
   *  @param mass out, [n n] row by row: kg, kg m and kg m^2   @param n how many coordinates there are
   *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree);
   *          NOT_FINITE (bodies too far apart or too heavy for numbers); BUSY; OUT_OF_MEMORY */
  carom_tree_get_mass(world: number, body: bigint, mass: number, n: bigint, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_vehicle_desc_init(desc: number, struct_size: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_wheel_desc_init(desc: number, struct_size: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_vehicle_input_init(input: number, struct_size: number): number;
  /** At idle speed, at rest.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_vehicle_init(vehicle: number, struct_size: number): number;
  /** In the air, at rest.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_wheel_init(wheel: number, struct_size: number): number;
  /** Look down, turn wheels and engine through dt, and leave the mean forces for the next step, which is to take dt. They
   *  add to forces that are pending. They keep a vehicle awake.
   *  @param desc with a chassis
   *  @param wheel_descs [n] one after another, each of the first one's struct_size
   *  @param n 1 to CAROM_VEHICLE_WHEELS
   *  @param input what the driver does
   *  @param vehicle state, changes
   *  @param wheels [n] states, change: as wheel_descs
   *  @param dt s, [1e-4, 0.1]
   *  @accuracy of the prediction first order in 1 ms; it leaves out what else acts on the chassis but gravity and
   *            pending forces. A chassis that swings on its springs faster than a third of 1 / dt trembles. Of springs
   *            stiffer than (m / 4) / 1 ms^2, m what the chassis weighs at the wheel, so much acts
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits; a half-space or scenery as shape); *_HANDLE;
   *          NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a chassis that is not dynamic, a gear that it has not); BUSY;
   *          REENTRANT; OUT_OF_MEMORY */
  carom_vehicle_drive(world: number, desc: number, wheel_descs: number, n: bigint, input: number, vehicle: number, wheels: number, dt: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_world_desc_init(desc: number, struct_size: number): number;
  /** @param desc may be NULL: defaults   @owns the caller: carom_world_destroy(), before the engine
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; LIMIT (65,535 engines and worlds in
   *          all); OUT_OF_MEMORY   @thread engine */
  carom_world_create(engine: number, desc: number, world: number, error: number): number;
  /** Destroys its bodies, colliders, materials and particles too.   @status OK; NULL_ARGUMENT; BUSY; REENTRANT */
  carom_world_destroy(world: number, error: number): number;
  /** Advance by dt.
   *  @param dt s, in [1e-9, 1]
   *  @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
   *  Out of memory: no body has moved and forces are still pending; contact caches may have been dropped.
   *  A plugin that misbehaves does not fail the step: its pairs are skipped and carom_world_get_faults() reports it. */
  carom_world_step(world: number, dt: number, error: number): number;
  /** @param value within the dial's bounds; whole for choices and integers
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_world_set_dial(world: number, dial: number, value: number, error: number): number;
  /** @param value as carom_world_set_dial() takes it   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY */
  carom_world_get_dial(world: number, dial: number, value: number, error: number): number;
  /** Set all dials that presets speak of, from the next step on; see carom_preset_get_dial(). Later calls of
   *  carom_world_set_dial() change them one by one.   @param preset CAROM_PRESET_*
   *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT */
  carom_world_set_preset(world: number, preset: number, error: number): number;
  /** @param gravity [3] m/s^2, |each| <= 1e6   @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
  carom_world_set_gravity(world: number, gravity: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; BUSY */
  carom_world_get_gravity(world: number, gravity: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
  carom_world_get_report(world: number, report: number, error: number): number;
  /** Static name of a stage ("broad"), or "?".
   *  @param stage CAROM_STAGE_* */
  carom_stage_name(stage: number): number;
  /** Copy out the contact points of the last step, in a deterministic order; those of colliders destroyed since are gone.
   *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
   *  @param stride   sizeof(carom_contact) as the caller knows it
   *  @param count    out: how many there are (may exceed capacity; capacity are written)
   *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
  carom_world_get_contacts(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** Copy out the contact groups of the last step, in a deterministic order. Other solvers than CAROM_SOLVER_AUTO treat
   *  all groups alike: then there are none.
   *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
   *  @param stride   sizeof(carom_group) as the caller knows it
   *  @param count    out: how many there are (may exceed capacity; capacity are written)
   *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
  carom_world_get_groups(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** Copy out the faults of the last step; arguments as carom_world_get_contacts(). */
  carom_world_get_faults(world: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** 64-bit hash of the dynamic state: equal iff (up to collision of the hash) every pose, velocity and cached contact
   *  has the same bits, and every particle's position and velocity.
   *  @param hash of the state
   *  @status OK; NULL_ARGUMENT; BUSY   @thread reader */
  carom_world_hash(world: number, hash: number, error: number): number;
  /** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
  carom_query_desc_init(desc: number, struct_size: number): number;
  /** What one ray meets first: origin + t direction, 0 <= t <= max.
   *  @param origin [3] m   @param direction [3] m per unit of t, any length   @param max >= 0, may be infinite
   *  @param desc   may be NULL: defaults   @param size sizeof(carom_world_hit) as the caller knows it
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE (desc->ignore); NOT_FINITE; OUT_OF_RANGE;
   *          BUFFER_TOO_SMALL (size); BUSY; OUT_OF_MEMORY   @thread reader */
  carom_world_cast_ray(world: number, origin: number, direction: number, max: number, desc: number, hit: number, size: bigint, error: number): number;
  /** What each of many rays meets first, or whether it meets anything. A bad ray (not finite, or max negative) spoils no
   *  other: its outcome is CAROM_CAST_BAD_RAY. Nothing is allocated per ray.
   *  @param want   CAROM_WANT_*   @param desc may be NULL: defaults
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE (desc->ignore); NOT_FINITE;
   *          OUT_OF_RANGE; BUFFER_TOO_SMALL (a stride); BUSY; OUT_OF_MEMORY   @thread reader */
  carom_world_cast_rays(world: number, rays: number, want: number, desc: number, hits: number, error: number): number;
  /** All that each of many rays meets: by ray, then by time, then by slot. A bad ray has one record that says so.
   *  @param dst    [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
   *  @param stride sizeof(carom_world_hit) as the caller knows it
   *  @param count  out: how many there are (may exceed capacity; the first `capacity` are written)
   *  @status as carom_world_cast_rays()   @thread reader */
  carom_world_cast_rays_all(world: number, rays: number, desc: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** What each of many shapes meets first as it moves by its motion without turning, or whether it meets anything.
   *  @param shapes every shape, position, orientation and motion must be good, else nothing is written
   *  @param want   CAROM_WANT_*   @param desc may be NULL: defaults
   *  @param dst    [shapes->count] elements `stride` bytes apart   @param stride 0: tightly packed
   *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a half-space as query shape); UNKNOWN_ENUM; *_HANDLE;
   *  NOT_FINITE;
   *          NOT_UNIT; OUT_OF_RANGE; BUFFER_TOO_SMALL (a stride); BUSY; OUT_OF_MEMORY   @thread reader */
  carom_world_cast_shapes(world: number, shapes: number, want: number, desc: number, dst: number, stride: bigint, error: number): number;
  /** All that each of many moving shapes meets: by shape, then by time, then by slot; as carom_world_cast_rays_all().
   *  @status as carom_world_cast_rays_all(); NOT_UNIT   @thread reader */
  carom_world_cast_shapes_all(world: number, shapes: number, desc: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** All that overlaps each of many shapes (or is nearer than desc->target): by shape, then by slot; arguments as
   *  carom_world_cast_rays_all().   @status as carom_world_cast_rays_all(); NOT_UNIT   @thread reader */
  carom_world_overlap_shapes(world: number, shapes: number, desc: number, dst: number, stride: bigint, capacity: bigint, count: number, error: number): number;
  /** The collider nearest to each of many shapes or points, and where: least signed distance.
   *  @param reach  m, >= 0, may be infinite: farther ones are not looked for (then: MISS)
   *  @param dst    as carom_world_cast_shapes()
   *  @status as carom_world_cast_shapes()   @thread reader */
  carom_world_find_nearest(world: number, shapes: number, reach: number, desc: number, dst: number, stride: bigint, error: number): number;
}
