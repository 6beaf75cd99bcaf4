using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

namespace Carom
{
    /// <summary>A shape written in C#: its farthest point along a direction of any length. Carom.carom_support_fn says what it must keep to.
    /// What it throws is a fault of the shape.</summary>
    public delegate Vec3 Support(ReadOnlySpan<double> parameters, Vec3 direction);

    /// <summary>Owns plugins and shapes, makes worlds. Once disposed it lives on until its last world is. Any thread may use it.</summary>
    public sealed unsafe class Engine : SafeHandleZeroOrMinusOneIsInvalid
    {
        private readonly List<object> delegates = new List<object>();  // what C has pointers to
        private readonly List<IntPtr> memory = new List<IntPtr>();

        /// <param name="threads">that share the work of a step; the outcome is the same to the bit</param>
        public Engine(int threads = 1) : base(true)
        {
            Library.Check();
            SetHandle(Raw.carom_engine_create());
            if (threads <= 1) return;
            JobsDesc jobs = JobsDesc.New();
            jobs.Threads = (uint)threads;
            Raw.carom_engine_set_jobs(this, jobs);
        }

        protected override bool ReleaseHandle()
        {
            bool done = Raw.carom_engine_destroy(handle, null) == Raw.CAROM_OK;
            memory.ForEach(Marshal.FreeCoTaskMem);
            return done;
        }

        /// <summary>An empty world, with gravity along -y.</summary>
        public World World() => new World(this, Raw.carom_world_create(this));
        /// <summary>By the name of its plugin: "sphere", "box", "half_space", or one on $CAROM_PLUGIN_PATH.</summary>
        /// <returns>a handle, as of all that makes shapes and plugins</returns>
        public ulong Shape(string name, params double[] parameters) => Raw.carom_shape_create_named(this, name, parameters);
        /// <summary>A shape of a plugin.</summary>
        public ulong Shape(ulong plugin, params double[] parameters) => Raw.carom_shape_create(this, plugin, parameters);
        /// <summary>The convex hull of shapes at places, or all at the origin, grown by a radius.</summary>
        public ulong HullOf(ReadOnlySpan<ulong> shapes, ReadOnlySpan<Vec3> positions, double radius = 0) =>
            Raw.carom_shape_create_hull_of(this, shapes, positions, default(ReadOnlySpan<Quat>), default(ReadOnlySpan<Vec3>), radius);

        /// <summary>A kind of shape whose support function is C#, called on the thread that makes the call. It lives as long as the engine.</summary>
        /// <param name="parameters">a value outside [min, max] is refused when a shape is made; unit: "m", or "1"</param>
        public ulong Plugin(string id, Support support, params (string name, string unit, double min, double max)[] parameters)
        {
            carom_support_fn ask = (user, p, n, direction, farthest) =>
            {
                try { *(Vec3*)farthest = support(new ReadOnlySpan<double>(p, (int)n), *(Vec3*)direction); return 0; }
                catch (Exception) { return 1; }  // nothing may be thrown through C
            };
            var table = (Param*)Keep(Marshal.AllocCoTaskMem(sizeof(Param) * (parameters.Length + 1)));
            for (int i = 0; i < parameters.Length; i++)
                table[i] = new Param { Name = Text(parameters[i].name), Unit = Text(parameters[i].unit), Min = parameters[i].min, Max = parameters[i].max };
            var description = (ShapePlugin*)Keep(Marshal.AllocCoTaskMem(sizeof(ShapePlugin)));
            *description = new ShapePlugin
            {
                StructSize = (uint)sizeof(ShapePlugin), AbiMajor = Raw.CAROM_PLUGIN_ABI_MAJOR, AbiMinor = Raw.CAROM_PLUGIN_ABI_MINOR,
                Flags = Raw.CAROM_PLUGIN_HOST_THREAD, Id = Text(id), Version = 1, ParamCount = (uint)parameters.Length, Params = table,
                Support = Marshal.GetFunctionPointerForDelegate(ask)
            };
            lock (delegates) delegates.Add(ask);
            ulong plugin;
            Call.Check(Raw.carom_plugin_register(this, description, &plugin, Call.Error));  // it keeps the pointer
            return plugin;
        }

        private IntPtr Keep(IntPtr at) { lock (memory) memory.Add(at); return at; }
        private byte* Text(string text) => (byte*)Keep(Marshal.StringToCoTaskMemUTF8(text));
    }
}
