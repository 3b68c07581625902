using System.Collections.Concurrent;
using Msisf.Core.Mesh;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

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
        CancellationToken cancellation)
    {
        bool isFlat = options.Normals == NormalModel.Facet && !options.Reflectance.DependsOnViewer;
        WorkerTeam.Run(threads, visible.Height, (_, row) =>
        {
            int start = row * visible.Width;
            Span<double> factors = radianceFactors.AsSpan(start, visible.Width);
            if (isFlat)
            {
                AddFlat(sunlight, start, options.Reflectance, weight, factors);
                return;
            }

            Scratch scratch = _idle.TryTake(out Scratch? idle) ? idle : new Scratch(_surface);
            visible.Read(row + 1, scratch.Row);
            SmoothNormals? normals = options.Normals == NormalModel.Smooth ? scratch.Normals : null;
            for (int i = 0; i < scratch.Row.Count; i++)
            {
                int column = scratch.Row.Columns[i];
                double fraction = sunlight.VisibleFraction(start + column);
                if (fraction > 0.0)
                {
                    double cosIncidence = sunlight.CosIncidence[start + column];
                    factors[column] += weight * fraction
                        * RadianceFactor(visible, row + 1, scratch.Row, i, cosIncidence, normals, light, options.Reflectance);
                }
            }

            _idle.Add(scratch);
        }, cancellation);
    }

    /// <summary>The normal that shades a point.</summary>
    /// <param name="hit">The point, with its facet's normal.</param>
    /// <param name="cameraMoonMe">m, MOON_ME.</param>
    public Vector3D SmoothNormal(SurfaceHit hit, Vector3D cameraMoonMe)
    {
        Scratch scratch = _idle.TryTake(out Scratch? idle) ? idle : new Scratch(_surface);
        Vector3D normal = Smooth(scratch.Normals, hit.Facet, hit.NormalMoonMe, hit.PointMoonMe, cameraMoonMe);
        _idle.Add(scratch);
        return normal;
    }

    private static void AddFlat(PixelSunlight sunlight, int start, IReflectance law, double weight, Span<double> factors)
    {
        ReadOnlySpan<double> cosines = sunlight.CosIncidence.AsSpan(start, factors.Length);
        ReadOnlySpan<byte> hidden = sunlight.Hidden.AsSpan(start, factors.Length);
        bool isPoint = sunlight.VisibleFractions.Length == 0;
        for (int column = 0; column < factors.Length; column++)
        {
            if (hidden[column] == 0 && cosines[column] > 0.0)
            {
                double share = isPoint ? weight : weight * sunlight.VisibleFractions[start + column];
                factors[column] += share * law.RadianceFactor(cosines[column], cosEmission: 1.0, phaseHaversine: 0.0);
            }
        }
    }

    private static double RadianceFactor(
        VisibleSurface visible, int y, SurfaceRow row, int i, double cosIncidence, SmoothNormals? normals, SceneLight light,
        IReflectance law)
    {
        Vector3D camera = visible.View.Camera.PositionMoonMe;
        Vector3D point = new(row.X[i], row.Y[i], row.Z[i]);
        Vector3D normal = new(row.NormalX[i], row.NormalY[i], row.NormalZ[i]);

        // Lengths of 1 m to 1e12 m: their squares neither overflow nor vanish.
        Vector3D toLight = light.PositionMoonMe - point;
        toLight /= Math.Sqrt(toLight.LengthSquared);
        Vector3D toCamera = camera - point;
        toCamera /= Math.Sqrt(toCamera.LengthSquared);
        if (normals is not null && Smooth(normals, visible.FacetOf(y, row.Facets[i]), normal, point, camera) is var smooth
            && smooth != normal)
        {
            normal = smooth;
            cosIncidence = Math.Min(Vector3D.Dot(normal, toLight), 1.0);
        }

        // A smooth normal can look away from the light where the facet does not; a facet can be seen edge-on.
        double cosEmission = Math.Min(Vector3D.Dot(normal, toCamera), 1.0);
        return cosIncidence > 0.0 && cosEmission > 0.0
            ? law.RadianceFactor(cosIncidence, cosEmission, PhaseAngle.Haversine(toLight, toCamera))
            : 0.0;
    }

    /// <summary>
    /// At the limb a normal between the samples can look away from the camera, where no law has a value: there the facet's own is left.
    /// </summary>
    private static Vector3D Smooth(SmoothNormals normals, FacetId facet, Vector3D facetNormal, Vector3D point, Vector3D camera)
    {
        Vector3D normal = normals.At(facet, facetNormal, point);
        return Vector3D.Dot(normal, camera - point) > 0.0 ? normal : facetNormal;
    }

    /// <summary>What one thread works with.</summary>
    private sealed class Scratch(SurfaceModel surface)
    {
        public SurfaceRow Row { get; } = new();

        public SmoothNormals Normals { get; } = new(surface);
    }
}
