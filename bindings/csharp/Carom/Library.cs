using System;
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

        /// <summary>Is it one that Raw can call? Version, and the layout of every struct.</summary>
        internal static void Check()
        {
            if (fits) return;
            try { Raw.carom_abi_check(Raw.Layout); }
            catch (EntryPointNotFoundException)
            {
                throw new CaromException(Raw.CAROM_E_UNSUPPORTED, file + " is no libcarom, or an older one",
                    "install a libcarom and a package Carom of one version");
            }
            fits = true;
        }
    }
}
