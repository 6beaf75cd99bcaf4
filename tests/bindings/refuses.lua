-- What load() of carom.lua says of libraries that do not fit: the file, and what to do.   luajit refuses.lua LIBRARY FOLDER
local library, folder = arg[1], arg[2]
local carom = require("carom")

local function refused(path, why, cure)
  local loaded, said = pcall(carom.load, path)
  assert(not loaded, path .. " was loaded")
  assert(said:find(path, 1, true) and said:find(why) and said:find(cure), ("of %s it says: %s"):format(path, said))
end
local function changed(name, change)
  local file = assert(io.open(library, "rb"))
  local path = folder .. "/" .. name
  local to = assert(io.open(path, "wb"))
  to:write(change(file:read("*a")))
  file:close()
  to:close()
  return path
end

refused("/no/such/libcarom.so", "No such file", "Install libcarom 0")
refused(changed("short.so", function(image) return image:sub(1, 40) end), "cannot load", "Install libcarom 0")
refused(changed("processor.so", function(image) return image:sub(1, 18) .. "\243\0" .. image:sub(21) end), "cannot load", "for this system and processor")
refused("libm.so.6", "carom_abi_manifest", "of one version")
local function layout(image)
  local from, to = image:find("carom_contact.separation %d+ 8 f64\n")
  local row = image:sub(from, to)
  return image:sub(1, from - 1) .. row:gsub(" (%d)", function(d) return " " .. (d + 1) % 10 end, 1) .. image:sub(to + 1)
end
refused(changed("layout.so", layout), "field separation of carom_contact", "Install a libcarom and a module of one version")
assert(carom.load(library))
