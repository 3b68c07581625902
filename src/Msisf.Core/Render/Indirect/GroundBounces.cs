using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Shading;

namespace Msisf.Core.Render.Indirect;

/// <summary>Finds the brightness of the points that stand for the ground, and light that went from ground to ground before.</summary>
internal sealed class GroundBounces(GroundTree tree, GroundLights lights, FrameCamera camera, NativeRenderOptions options)
{
    /// <summary>Rays of a point to near ground, and points of far ground; of points that throw light the errors are averaged.</summary>
    private const int NearSamples = 12;
    private const int FarSamples = 64;

    /// <summary>Finds by what the map scales the points.</summary>
    public void Start(int threads, CancellationToken cancellation)
    {
        Run(threads, (first, end) =>
        {
            RowReflection reflection = new(tree.Surface);
            reflection.Points.Clear(end - first);
            for (int i = first; i < end; i++)
            {
                reflection.Points.Add(i, 1.0, lights.Points[i], lights.Normals[i], 1.0);
            }

            reflection.FindScales(camera, options);
            reflection.Points.Factors.AsSpan(0, end - first).CopyTo(lights.Scales.AsSpan(first));
        }, cancellation);
        lights.FindBright();
    }

    /// <summary>Adds another reflection: each point gets the light of all others.</summary>
    /// <param name="number">Number of the reflection, from 1.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Add(int number, int threads, CancellationToken cancellation)
    {
        if (lights.Bright.Length == 0)
        {
            return;
        }

        double[] irradiance = new double[lights.Count];
        Vector3D[] directions = new Vector3D[lights.Count];
        ConcurrentBag<LightGather> idle = [];
        Run(threads, (first, end) =>
        {
            LightGather gather = idle.TryTake(out LightGather? known) ? known : new LightGather(tree, lights, camera, options);
            GatheredLight found = new(isIrradiance: true);
            gather.Group.Clear();
            for (int i = first; i < end; i++)
            {
                Vector3D normal = lights.Normals[i];
                gather.Group.Add(lights.Points[i], normal, normal, normal, lights.Reaches[i], i);
            }

            gather.Begin(shared: null);
            gather.Far.AddOther(FarSamples, (first * IndirectLight.MaxBounces) + number, found); // many groups: errors cancel
            gather.AddNear(NearSamples, top: 0.0, number, found);
            found.Values.AsSpan(0, end - first).CopyTo(irradiance.AsSpan(first));
            found.Directions.AsSpan(0, end - first).CopyTo(directions.AsSpan(first));
            idle.Add(gather);
        }, cancellation);
        for (int i = 0; i < lights.Count; i++)
        {
            bool isLit = irradiance[i] > 0.0;
            lights.ToGround[i] = isLit ? directions[i].Normalized() : lights.Normals[i];
            lights.FromGround[i] = isLit ? irradiance[i] / Vector3D.Dot(lights.ToGround[i], lights.Normals[i]) : 0.0;
        }

        lights.FindBright();
    }

    private void Run(int threads, Action<int, int> work, CancellationToken cancellation) => WorkerTeam.Run(
        threads,
        (lights.Count + Receivers.Size - 1) / Receivers.Size,
        (_, group) => work(group * Receivers.Size, Math.Min(lights.Count, (group + 1) * Receivers.Size)),
        cancellation);
}
