using System;
using System.Linq;
using System.Runtime.InteropServices;

namespace Carom
{
    /// <summary>Finds libcarom, once: $CAROM_LIBRARY, else the system's loader by its name.</summary>
    internal static class Library
    {
        private static string file;
        private static bool fits;

        /// <summary>Before the first call of Raw.</summary>
        internal static void Name() =>
            NativeLibrary.SetDllImportResolver(typeof(Library).Assembly, (name, assembly, path) => name == Raw.File ? Load() : IntPtr.Zero);

        private static IntPtr Load()
        {
            string given = Environment.GetEnvironmentVariable("CAROM_LIBRARY");
            string usual = RuntimeInformation.IsOSPlatform(OSPlatform.Windows) ? "carom.dll"
                : RuntimeInformation.IsOSPlatform(OSPlatform.OSX) ? Raw.Soname.Replace(".so", "") + ".dylib" : Raw.Soname;
            file = string.IsNullOrEmpty(given) ? usual : given;
            try { return NativeLibrary.Load(file); }
            catch (Exception problem) when (problem is DllNotFoundException || problem is BadImageFormatException)
            {
                const string Before = "environment variable:";  // then come the loader's own words
                string all = problem.Message, why = all.Substring(Math.Max(0, all.LastIndexOf(Before) + Before.Length)).Trim();
                throw new CaromException(Raw.CAROM_E_NOT_FOUND, $"cannot load {file}: {why.Split('\n')[0]}",
                    $"install libcarom {Raw.Version} for this system and processor, or set CAROM_LIBRARY to the path of {usual}");
            }
        }

        private static CaromException Unfit(string what) =>
            new CaromException(Raw.CAROM_E_UNSUPPORTED, file + " " + what, "install a libcarom and a package Carom of one version");

        /// <summary>Is it one that Raw can call? Version, and the layout of every struct.</summary>
        internal static void Check()
        {
            if (fits) return;
            try { Check(Raw.carom_abi_manifest(), file); }
            catch (EntryPointNotFoundException) { throw Unfit("is no libcarom, or an older one"); }
            fits = true;
        }

        internal static void Check(string manifest, string name)
        {
            file = name;
            string[][] rows = manifest.Split('\n').Select(line => line.Split(' ')).ToArray();
            string version = rows[0].Last();
            Version here = Version.Parse(Raw.Version);
            bool same = Version.TryParse(version, out Version there) && there.Major == here.Major && (here.Major > 0 || there.Minor == here.Minor);
            if (!same || there < here) throw Unfit($"is of version {version}, this package of {Raw.Version}");
            ILookup<string, string[]> named = rows.ToLookup(row => row[0]);
            foreach (string line in Raw.Layout.Split(new[] { '\n' }, StringSplitOptions.RemoveEmptyEntries))
            {
                string[] ours = line.Trim().Split(' '), theirs = named[ours[0]].FirstOrDefault() ?? throw Unfit("has no " + ours[0]);
                bool longer = ours[3] == "struct" && theirs[3] == "struct" && int.Parse(theirs[2]) > int.Parse(ours[2]);  // its tail is not ours
                if (!ours.SequenceEqual(theirs) && !longer)
                    throw Unfit($"has {ours[0]} as {theirs[3]} of {theirs[2]} bytes at {theirs[1]}, this package as {ours[3]} of {ours[2]} bytes at {ours[1]}");
            }
        }
    }
}
