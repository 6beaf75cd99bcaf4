-- Carom for LuaJIT: the C interface under its own names, checked against the library that is loaded.
--
--   local carom = require("carom").load("/path/of/libcarom.so.0.9")
--   local engine = carom.out("carom_engine *")
--   carom.check("carom_engine_create", nil, engine)            -- raises an error with message and remedy
--   carom.lib.carom_result_name(-1), carom.CAROM_E_BUSY, ...   -- everything else as in C
--
-- @param of check: the arguments but for the last, which is this module's carom_error.
local ffi = require("ffi")
local constants = require("carom_cdef")

-- Is what a library says of its layout (carom_abi_manifest) what ffi makes of carom_cdef.lua?
local function check_layout(manifest)
  local version, rows = manifest:match("^carom ([%d.]+)\n"), 0
  for name, field, offset, size, kind in manifest:gmatch("(carom_[%w_]+)%.?([%w_]*) (%d+) (%d+) (%S+)\n") do
    offset, size, rows = tonumber(offset), tonumber(size), rows + 1
    local known, here = pcall(field == "" and ffi.sizeof or ffi.offsetof, name, field ~= "" and field or nil)
    if known and field == "" and here > size then  -- a longer one is a newer library's; what it has more is not ours
      error(("%s has %d bytes in the library (%s), %d here (%s)"):format(name, size, version, here, constants.VERSION))
    elseif known and field ~= "" and here and here ~= offset then
      error(("field %s of %s is at offset %d in the library (%s), at %d here (%s)"):format(field, name, offset, version, here, constants.VERSION))
    end
  end
  if rows < constants.ROWS then
    error(("the library (%s) is older than this module (%s)"):format(version, constants.VERSION))
  end
  return rows
end

local M = setmetatable({check_layout = check_layout}, {__index = constants})

-- Load the library; an error says what does not fit.
function M.load(path)
  local found, lib = pcall(ffi.load, path)
  if not found then
    error(("cannot load %s (%s). Install libcarom %s for this system and processor, or give the path of one"):format(path, lib, constants.VERSION), 2)
  end
  local fits, why = pcall(function() return check_layout(ffi.string(lib.carom_abi_manifest())) end)
  if not fits then
    error(("%s does not fit: %s. Install a libcarom and a module of one version"):format(path, why), 2)
  end
  M.lib = lib
  M.error = ffi.new("carom_error", {struct_size = ffi.sizeof("carom_error")})
  return M
end

-- Room for one value that a call writes.
function M.out(type) return ffi.new(ffi.typeof("$[1]", ffi.typeof(type))) end

-- A struct, with its defaults where it has an _init.
function M.new(type)
  local struct = ffi.new(type)
  local has_init, init = pcall(function() return M.lib[type .. "_init"] end)
  if has_init then init(struct, ffi.sizeof(type)) else struct.struct_size = ffi.sizeof(type) end
  return struct
end

-- Call a function whose last argument is a carom_error*.
function M.check(name, ...)
  local arguments = {...}
  local n = select("#", ...)
  arguments[n + 1] = M.error
  if M.lib[name](unpack(arguments, 1, n + 1)) ~= constants.CAROM_OK then
    error(("%s: %s. Remedy: %s"):format(ffi.string(M.lib.carom_result_name(M.error.code)), ffi.string(M.error.message), ffi.string(M.error.remedy)), 2)
  end
end

-- A world as a string (flags: carom.CAROM_SNAPSHOT_STATE, the default, or _WHOLE), and back.
function M.save(world, flags)
  local size = M.out("uint64_t")
  M.check("carom_world_save", world, flags or 0, nil, 0, size)
  local buffer = ffi.new("uint8_t[?]", size[0])
  M.check("carom_world_save", world, flags or 0, buffer, size[0], size)
  return ffi.string(buffer, size[0])
end
function M.restore(world, state) M.check("carom_world_restore", world, state, #state) end

-- A copy of a world, to be destroyed as any; and what a handle of the one is in another.
function M.fork(world)
  local copy = M.out("carom_world *")
  M.check("carom_world_fork", world, copy)
  return copy[0]
end
function M.counterpart(world, handle)
  local pair = ffi.new("uint64_t[2]", handle)
  M.check("carom_world_translate_handles", world, pair, 1, pair + 1)
  return pair[1]
end

-- Write every call on a world to a file that io.open() opened, until the function that comes back is called.
function M.record(world, file, states)
  local write = ffi.cast("carom_write_fn", function(_, bytes, size)
    return file:write(ffi.string(bytes, size)) and 0 or 1
  end)
  M.check("carom_world_record_begin", world, states and M.CAROM_RECORD_STATES or M.CAROM_RECORD_HASHES, write, nil)
  return function()
    local ended, why = pcall(M.check, "carom_world_record_end", world)
    write:free()
    if not ended then error(why, 2) end
  end
end

return M
