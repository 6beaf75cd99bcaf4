using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using static Carom.Call;

namespace Carom
{
    /// <summary>Owns plugins and shapes, makes worlds. Once disposed it lives on until its last world is. Any thread may use it.</summary>
    public sealed unsafe class Engine : SafeHandle
    {
        private readonly List<object> delegates = new List<object>();  // what C has pointers to
        private readonly List<IntPtr> memory = new List<IntPtr>();

        /// <param name="threads">that share the work of a step; the outcome is the same to the bit</param>
        public Engine(int threads = 1) : base(IntPtr.Zero, true)
        {
            Library.Check();
            IntPtr pointer;
            Check(Raw.carom_engine_create(null, &pointer, Call.Error));
            SetHandle(pointer);
            if (threads <= 1) return;
            JobsDesc jobs = JobsDesc.New();
            jobs.Threads = (uint)threads;
            int result = Raw.carom_engine_set_jobs(this, &jobs, Call.Error);
            if (result != Raw.CAROM_OK) Dispose();
            Check(result);
        }

        [DllImport(Raw.File, CallingConvention = CallingConvention.Cdecl)]
        private static extern int carom_engine_destroy(IntPtr engine, Error* error);
        public override bool IsInvalid => handle == IntPtr.Zero;
        protected override bool ReleaseHandle()
        {
            bool done = carom_engine_destroy(handle, null) == Raw.CAROM_OK;
            memory.ForEach(Marshal.FreeHGlobal);
            return done;
        }

        /// <summary>An empty world, with gravity along -y.</summary>
        public World World() { IntPtr made; Check(Raw.carom_world_create(this, null, &made, Call.Error)); return new World(this, made); }

        /// <summary>By the name of its plugin: "sphere", "box", "half_space", or one on $CAROM_PLUGIN_PATH.</summary>
        /// <returns>a handle, as of all that makes shapes and plugins</returns>
        public ulong Shape(string name, params double[] parameters)
        {
            ulong shape;
            double none;
            fixed (double* p = parameters)
                Check(Raw.carom_shape_create_named(this, name, p == null ? &none : p, (ulong)parameters.Length, &shape, Call.Error));
            return shape;
        }

        /// <summary>A shape of a plugin.</summary>
        public ulong Shape(ulong plugin, params double[] parameters)
        {
            ulong shape;
            fixed (double* p = parameters) Check(Raw.carom_shape_create(this, plugin, p, (ulong)parameters.Length, &shape, Call.Error));
            return shape;
        }

        /// <summary>The convex hull of shapes at places, grown by a radius.</summary>
        public ulong HullOf(ReadOnlySpan<ulong> shapes, ReadOnlySpan<Vec3> positions, double radius = 0)
        {
            if (shapes.Length != positions.Length)
                throw new CaromException(Raw.CAROM_E_OUT_OF_RANGE, $"{positions.Length} positions for {shapes.Length} shapes", "give as many of each");
            ulong shape;
            fixed (ulong* s = shapes)
            fixed (Vec3* p = positions)
                Check(Raw.carom_shape_create_hull_of(this, s, (ulong)shapes.Length, (double*)p, null, null, radius, &shape, Call.Error));
            return shape;
        }

        /// <summary>A kind of shape whose support function is C#, called on the thread that makes the call. It lives as long as the engine.</summary>
        public ulong Plugin(string id, Support support, params ShapeParam[] parameters)
        {
            carom_support_fn ask = (user, p, n, direction, farthest) =>
            {
                try { *(Vec3*)farthest = support(new ReadOnlySpan<double>(p, (int)n), *(Vec3*)direction); return 0; }
                catch (Exception) { return 1; }  // nothing may be thrown through C
            };
            var table = (Param*)Room(sizeof(Param) * (parameters.Length + 1));
            for (int i = 0; i < parameters.Length; i++)
                table[i] = new Param { Name = Text(parameters[i].Name), Unit = Text(parameters[i].Unit), Min = parameters[i].Min, Max = parameters[i].Max };
            var description = (ShapePlugin*)Room(sizeof(ShapePlugin));
            *description = new ShapePlugin
            {
                StructSize = (uint)sizeof(ShapePlugin), AbiMajor = Raw.CAROM_PLUGIN_ABI_MAJOR, AbiMinor = Raw.CAROM_PLUGIN_ABI_MINOR,
                Flags = Raw.CAROM_PLUGIN_HOST_THREAD, Id = Text(id), Version = 1, ParamCount = (uint)parameters.Length, Params = table,
                Support = Marshal.GetFunctionPointerForDelegate(ask)
            };
            lock (delegates) delegates.Add(ask);
            ulong plugin;
            Check(Raw.carom_plugin_register(this, description, &plugin, Call.Error));
            return plugin;
        }

        private IntPtr Room(int bytes) { IntPtr at = Marshal.AllocHGlobal(bytes); lock (memory) memory.Add(at); return at; }

        private byte* Text(string text)
        {
            byte[] bytes = System.Text.Encoding.UTF8.GetBytes(text + "\0");
            IntPtr at = Room(bytes.Length);
            Marshal.Copy(bytes, 0, at, bytes.Length);
            return (byte*)at;
        }
    }
}
