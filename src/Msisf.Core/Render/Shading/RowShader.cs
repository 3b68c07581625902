using System.Collections.Concurrent;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Surface;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;

namespace Msisf.Core.Render.Shading;

/// <summary>Turns what the pixels show into radiance, row by row. Safe for several threads.</summary>
internal sealed class RowShader
{
    private readonly SurfaceModel _surface;
    private readonly ConcurrentBag<Scratch> _idle = [];

    public RowShader(SurfaceModel surface) => _surface = surface;

    /// <summary>Adds a sample's share to the radiance factors of a frame.</summary>
    /// <param name="visible">What the pixels show.</param>
    /// <param name="light">The Sun, or the lamp at the camera.</param>
    /// <param name="sunlight">Where it shines.</param>
    /// <param name="options">Law and normals.</param>
    /// <param name="weight">The sample's part of a pixel.</param>
    /// <param name="radianceFactors">I/F of each pixel so far, row by row.</param>
    /// <param name="threads">At most.</param>
    /// <param name="cancellation">Ends the work.</param>
    public void Shade(
        VisibleSurface visible,
        SceneLight light,
        PixelSunlight sunlight,
        NativeRenderOptions options,
        double weight,
        double[] radianceFactors,
        int threads,
        CancellationToken cancellation) => WorkerTeam.Run(threads, visible.Height, (_, row) =>
        {
            int start = row * visible.Width;
            ReadOnlySpan<double> cosines = sunlight.CosIncidence.AsSpan(start, visible.Width);
            ReadOnlySpan<byte> hidden = sunlight.Hidden.AsSpan(start, visible.Width);
            Span<double> factors = radianceFactors.AsSpan(start, visible.Width);
            if (options.Normals == NormalModel.Facet && !options.Reflectance.DependsOnViewer)
            {
                AddFlat(cosines, hidden, options.Reflectance, weight, factors);
                return;
            }

            Scratch scratch = _idle.TryTake(out Scratch? idle) ? idle : new Scratch(_surface);
            visible.Read(row + 1, scratch.Row);
            SmoothNormals? normals = options.Normals == NormalModel.Smooth ? scratch.Normals : null;
            for (int i = 0; i < scratch.Row.Count; i++)
            {
                int column = scratch.Row.Columns[i];
                if (cosines[column] > 0.0 && hidden[column] == 0)
                {
                    factors[column] += weight * RadianceFactor(visible, row + 1, scratch.Row, i, normals, light, options.Reflectance);
                }
            }

            _idle.Add(scratch);
        }, cancellation);

    /// <summary>The normal that shades a point.</summary>
    /// <param name="hit">The point, with its facet's normal.</param>
    public Vector3D SmoothNormal(SurfaceHit hit)
    {
        Scratch scratch = _idle.TryTake(out Scratch? idle) ? idle : new Scratch(_surface);
        Vector3D normal = scratch.Normals.At(hit.Facet, hit.NormalMoonMe, hit.PointMoonMe);
        _idle.Add(scratch);
        return normal;
    }

    private static void AddFlat(ReadOnlySpan<double> cosines, ReadOnlySpan<byte> hidden, IReflectance law, double weight, Span<double> factors)
    {
        for (int column = 0; column < cosines.Length; column++)
        {
            if (cosines[column] > 0.0 && hidden[column] == 0)
            {
                factors[column] += weight * law.RadianceFactor(cosines[column], cosEmission: 1.0, phaseHaversine: 0.0);
            }
        }
    }

    private static double RadianceFactor(
        VisibleSurface visible, int y, SurfaceRow row, int i, SmoothNormals? normals, SceneLight light, IReflectance law)
    {
        Vector3D point = new(row.X[i], row.Y[i], row.Z[i]);
        Vector3D normal = new(row.NormalX[i], row.NormalY[i], row.NormalZ[i]);
        normal = normals?.At(visible.FacetOf(y, row.Facets[i]), normal, point) ?? normal;

        // Lengths of 1 m to 1e12 m: their squares neither overflow nor vanish.
        Vector3D toLight = light.PositionMoonMe - point;
        toLight /= Math.Sqrt(toLight.LengthSquared);
        Vector3D toCamera = visible.View.Camera.PositionMoonMe - point;
        toCamera /= Math.Sqrt(toCamera.LengthSquared);
        double cosIncidence = Math.Min(Vector3D.Dot(normal, toLight), 1.0);
        double cosEmission = Math.Min(Vector3D.Dot(normal, toCamera), 1.0);

        // A smooth normal can look away from the light or the camera where the facet does not.
        return cosIncidence > 0.0 && cosEmission > 0.0
            ? law.RadianceFactor(cosIncidence, cosEmission, PhaseAngle.Haversine(toLight, toCamera))
            : 0.0;
    }

    /// <summary>What one thread works with.</summary>
    private sealed class Scratch(SurfaceModel surface)
    {
        public SurfaceRow Row { get; } = new();

        public SmoothNormals Normals { get; } = new(surface);
    }
}
