using Msisf.Core.Camera;
using Msisf.Core.Mesh;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;

namespace Msisf.Core.Render.Shading;

/// <summary>Computes the radiance factors of a row's lit pixels. Keeps buffers, so each thread needs its own object.</summary>
internal sealed class RowReflection(SurfaceModel surface)
{
    private readonly AlbedoSampler _albedo = new();

    /// <summary>Takes a row that is read anew.</summary>
    public SurfaceRow Row { get; } = new();

    /// <summary>Normals between the vertices.</summary>
    public SmoothNormals Normals { get; } = new(surface);

    /// <summary>The pixels.</summary>
    public SunlitPoints Points { get; } = new();

    /// <summary>Takes the pixels of a row that face the light, with their facets' normals.</summary>
    /// <param name="row">The row.</param>
    /// <param name="cosIncidence">Cosines of the incidence angles of its pixels.</param>
    /// <param name="width">Pixels of a whole row.</param>
    public void TakeFacing(SurfaceRow row, ReadOnlySpan<double> cosIncidence, int width)
    {
        Points.Clear(width);
        int end = row.Count;
        for (int i = 0; i < end; i++)
        {
            int first = i;
            while (i < end && cosIncidence[i] > 0.0)
            {
                i++;
            }

            if (i > first)
            {
                Points.AddRun(row, cosIncidence, first, i - first);
            }
        }
    }

    /// <summary>Computes the radiance factors of <see cref="Points"/>.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="options">Reflectance law and map.</param>
    public void FindFactors(PinholeCamera camera, SceneLight light, NativeRenderOptions options)
    {
        int count = Points.Count;
        Points.FindAngles(light.PositionMoonMe, camera.PositionMoonMe);
        if (options.Hapke is { } places)
        {
            places.FindFactors(Points, options.Albedo?.Reference);
        }
        else
        {
            options.Reflectance.RadianceFactors(
                Points.CosIncidence.AsSpan(0, count), Points.CosEmission.AsSpan(0, count), Points.PhaseHaversine.AsSpan(0, count),
                Points.Factors);
        }

        if (options.Albedo is { Reference: var there } map)
        {
            double? factorOfReference = options.Hapke is null
                ? options.Reflectance.RadianceFactor(there.CosIncidence, there.CosEmission, there.PhaseHaversine)
                : null;
            _albedo.Scale(Points, camera, options.SubsamplesPerAxis, map, factorOfReference);
        }
    }
}
