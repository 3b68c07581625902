using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shading;

namespace Msisf.Core.Render.Indirect;

/// <summary>Finds the brightness of the points that stand for the ground, and light that went from ground to ground before.</summary>
internal sealed class GroundBounces(GroundTree tree, GroundLights lights, FrameCamera camera, NativeRenderOptions options)
{
    /// <summary>Rays of a point to near ground; where points throw light, the errors of many are averaged.</summary>
    private const int NearSamples = 12;

    /// <summary>Cosine of a typical angle to light or view, where only the rough brightness of a point is asked for.</summary>
    private const double Typical = 0.5;

    /// <summary>Finds by what the map scales the points, and their rough brightness.</summary>
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
        FindPowers();
    }

    /// <summary>Adds another reflection: each point gets the light of all others.</summary>
    /// <param name="number">Number of the reflection, from 1.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Add(int number, int threads, CancellationToken cancellation)
    {
        double[] irradiance = new double[lights.Count];
        Vector3D[] directions = new Vector3D[lights.Count];
        Run(threads, (first, end) =>
        {
            LightGather gather = new(tree, lights, camera, options);
            GatheredLight found = new(isIrradiance: true);
            for (int i = first; i < end; i++)
            {
                Vector3D normal = lights.Normals[i];
                gather.Group.Add(lights.Points[i], normal, normal, normal, lights.Reaches[i], i);
            }

            gather.Begin();
            gather.Choose(LightGather.FirstChoices, (first * IndirectLight.MaxBounces) + number); // many groups: errors cancel
            gather.AddFar(found);
            gather.AddNear(NearSamples, top: 0.0, number, found);
            found.Values.AsSpan(0, end - first).CopyTo(irradiance.AsSpan(first));
            found.Directions.AsSpan(0, end - first).CopyTo(directions.AsSpan(first));
        }, cancellation);
        for (int i = 0; i < lights.Count; i++)
        {
            bool isLit = irradiance[i] > 0.0;
            lights.ToGround[i] = isLit ? directions[i].Normalized() : lights.Normals[i];
            lights.FromGround[i] = isLit ? irradiance[i] / Vector3D.Dot(lights.ToGround[i], lights.Normals[i]) : 0.0;
        }

        FindPowers();
    }

    private void FindPowers()
    {
        IReflectance law = options.Reflectance;
        double ofGround = law.RadianceFactor(Typical, Typical, Typical);
        for (int i = 0; i < lights.Count; i++)
        {
            double ofSun = lights.IsLit[i]
                ? law.RadianceFactor(Math.Min(1.0, Vector3D.Dot(lights.Normals[i], lights.ToSun[i])), Typical, Typical)
                : 0.0;
            lights.Powers[i] = lights.Areas[i] * lights.Scales[i] * (ofSun + (lights.FromGround[i] * ofGround));
        }

        lights.FindBright();
    }

    private void Run(int threads, Action<int, int> work, CancellationToken cancellation) => WorkerTeam.Run(
        threads,
        (lights.Count + Receivers.Size - 1) / Receivers.Size,
        (_, group) => work(group * Receivers.Size, Math.Min(lights.Count, (group + 1) * Receivers.Size)),
        cancellation);
}
