-- The scene of scene.c, by way of LuaJIT's foreign functions; prints the same hashes. usage: luajit scene.lua LIBRARY PLUGIN_DIR
local ffi = require("ffi")
local carom = require("carom").load(arg[1])
local check, new, out = carom.check, carom.new, carom.out

local function load_shape(engine, name, ...)
  local plugin, shape, n = out("carom_plugin"), out("carom_shape"), select("#", ...)
  check("carom_plugin_load", engine, arg[2] .. "/" .. name .. ".so", plugin)
  check("carom_shape_create", engine, plugin[0], ffi.new("double[?]", n, ...), n, shape)
  return shape[0]
end

local function vec3(x, y, z) return ffi.new("double[3]", x, y, z) end

-- A refusal arrives as an error that says what to do.
local made, refusal = pcall(check, "carom_engine_destroy", nil)
assert(not made and refusal:find("CAROM_E_NULL_ARGUMENT.*Remedy: "), refusal)
-- Another layout is refused by name.
local manifest = ffi.string(carom.lib.carom_abi_manifest())
local fits, why = pcall(carom.check_layout, (manifest:gsub("carom_contact.separation (%d+)", "carom_contact.separation 4")))
assert(not fits and why:find("field separation of carom_contact is at offset 4"), why)
assert(carom.check_layout(manifest) == select(2, manifest:gsub("\n", "")) - 1) -- every line was read
fits, why = pcall(carom.check_layout, (manifest:gsub("carom_contact%.[^\n]*\n", "")))
assert(not fits and why:find("older than this module"), why)

local pointer, shape = out("carom_engine *"), out("carom_shape")
check("carom_engine_create", nil, pointer)
local engine = pointer[0]
local shapes = {[0] = load_shape(engine, "sphere", 0.3), load_shape(engine, "box", 0.4, 0.25, 0.3), load_shape(engine, "template", 0.35, 0.4)}
check("carom_shape_create_half_space", engine, vec3(0, 1, 0), 0, shape)
local ground = shape[0]
local world_pointer, material = out("carom_world *"), out("carom_material")
check("carom_world_create", engine, nil, world_pointer)
local world = world_pointer[0]
check("carom_world_set_dial", world, carom.CAROM_DIAL_SUBSTEPS, 5)
check("carom_world_set_wind", world, vec3(1.5, 0, 0.5))
local surface = new("carom_material_desc")
surface.friction, surface.restitution = 0.6, 0.3
check("carom_material_create", world, surface, material)

local function add(desc, part)
  local body, collider = out("carom_body"), out("carom_collider")
  check("carom_body_create", world, desc, body)
  check("carom_collider_create", world, body[0], part, collider)
  return body[0]
end

for i = 0, 18 do
  local desc, part = new("carom_body_desc"), new("carom_collider_desc")
  part.material = material[0]
  if i == 0 then
    desc.type, part.shape = carom.CAROM_BODY_STATIC, ground
  else
    desc.position = vec3((i % 3) * 0.5, 0.6 + i * 0.55, (i % 2) * 0.4)
    desc.angular_velocity = vec3(0.5 * i, 0, 1)
    part.shape, part.density = shapes[i % 3], 400 + 50 * i
  end
  local body = add(desc, part)
  if i > 0 then check("carom_body_set_drag", world, body, 0.1, 0.02) end
end
local desc, part, hinge, joint = new("carom_body_desc"), new("carom_collider_desc"), new("carom_joint_desc"), out("carom_joint")
desc.position, part.shape = vec3(4.5, 3, 0), shapes[1]
hinge.kind, hinge.fields, hinge.body_b = carom.CAROM_JOINT_HINGE, carom.CAROM_JOINT_WORLD_FRAME, add(desc, part)
hinge.position_a, hinge.orientation_a = vec3(4, 3, 0), ffi.new("double[4]", 0, -0.6, 0, 0.8)
check("carom_joint_create", world, hinge, joint)

local hash = out("uint64_t")
for _ = 1, 3 do
  for _ = 1, 60 do check("carom_world_step", world, 1 / 60) end
  check("carom_world_hash", world, hash)
  print((bit.tohex(hash[0], 16)))
end
-- A copy goes on as it does, and so does a world that was taken back; what was done is written down.
local function hash_of(w)
  check("carom_world_hash", w, hash)
  return bit.tohex(hash[0], 16)
end
local state, copy = carom.save(world), carom.fork(world)
local body = carom.counterpart(copy, hinge.body_b)
assert(body ~= hinge.body_b and carom.counterpart(world, body) == hinge.body_b)
local name = os.tmpname()
local file = assert(io.open(name, "wb"))
local stop = carom.record(world, file)
for _ = 1, 10 do check("carom_world_step", world, 1 / 60) end
stop()
file:close()
file = assert(io.open(name, "rb"))
assert(file:read(8) == "CAROMREC")
file:close()
os.remove(name)
local ahead = hash_of(world)
for _ = 1, 10 do check("carom_world_step", copy, 1 / 60) end
assert(hash_of(copy) == ahead)
carom.restore(world, state)
for _ = 1, 10 do check("carom_world_step", world, 1 / 60) end
assert(hash_of(world) == ahead)
check("carom_world_destroy", copy)
check("carom_world_destroy", world)
check("carom_world_create", engine, nil, world_pointer)
carom.restore(world_pointer[0], carom.save(world_pointer[0], carom.CAROM_SNAPSHOT_WHOLE))
check("carom_world_destroy", world_pointer[0])
check("carom_engine_destroy", engine)
