using System.Collections.Concurrent;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Surface;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

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
    /// <param name="hidden">Of each pixel, row by row: not 0 if other terrain hides the light.</param>
    /// <param name="options">Law and normals.</param>
    /// <param name="weight">The sample's part of a pixel.</param>
    /// <param name="radianceFactors">I/F of each pixel so far, row by row.</param>
    /// <param name="threads">At most.</param>
    /// <param name="cancellation">Ends the work.</param>
    public void Shade(
        VisibleSurface visible,
        SceneLight light,
        byte[] hidden,
        NativeRenderOptions options,
        double weight,
        double[] radianceFactors,
        int threads,
        CancellationToken cancellation) => WorkerTeam.Run(threads, visible.Height, (_, row) =>
        {
            Scratch scratch = _idle.TryTake(out Scratch? idle) ? idle : new Scratch(_surface);
            int start = row * visible.Width;
            visible.Read(row + 1, scratch.Row);
            if (options.Normals == NormalModel.Smooth)
            {
                Smooth(visible, row + 1, light.PositionMoonMe, scratch);
            }

            AddRow(
                scratch.Row,
                visible.View.Camera.PositionMoonMe,
                light.PositionMoonMe,
                options.Reflectance,
                weight,
                hidden.AsSpan(start, visible.Width),
                radianceFactors.AsSpan(start, visible.Width));
            _idle.Add(scratch);
        }, cancellation);

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

    private static void AddRow(
        SurfaceRow row, Vector3D camera, Vector3D light, IReflectance law, double weight, ReadOnlySpan<byte> hidden, Span<double> radianceFactors)
    {
        bool dependsOnViewer = law.DependsOnViewer;
        for (int i = 0; i < row.Count; i++)
        {
            int column = row.Columns[i];
            if (hidden[column] != 0)
            {
                continue;
            }

            Vector3D normal = new(row.NormalX[i], row.NormalY[i], row.NormalZ[i]);
            Vector3D toLight = new(light.X - row.X[i], light.Y - row.Y[i], light.Z - row.Z[i]);

            // Lengths of 1 m to 1e12 m: their squares neither overflow nor vanish.
            double lightDistance = Math.Sqrt(toLight.LengthSquared);
            double cosIncidence = Math.Min(Vector3D.Dot(normal, toLight) / lightDistance, 1.0);
            if (!(cosIncidence > 0.0))
            {
                continue;
            }

            double cosEmission = 1.0;
            double phaseHaversine = 0.0;
            if (dependsOnViewer)
            {
                Vector3D toCamera = new(camera.X - row.X[i], camera.Y - row.Y[i], camera.Z - row.Z[i]);
                double cameraDistance = Math.Sqrt(toCamera.LengthSquared);
                cosEmission = Math.Min(Vector3D.Dot(normal, toCamera) / cameraDistance, 1.0);
                if (!(cosEmission > 0.0))
                {
                    continue; // a facet seen edge-on
                }

                phaseHaversine = PhaseAngle.Haversine(toLight / lightDistance, toCamera / cameraDistance);
            }

            radianceFactors[column] += weight * law.RadianceFactor(cosIncidence, cosEmission, phaseHaversine);
        }
    }

    /// <summary>Replaces the normals of the facets that face the light; the others stay dark by their own.</summary>
    private static void Smooth(VisibleSurface visible, int y, Vector3D light, Scratch scratch)
    {
        SurfaceRow row = scratch.Row;
        for (int i = 0; i < row.Count; i++)
        {
            Vector3D point = new(row.X[i], row.Y[i], row.Z[i]);
            Vector3D normal = new(row.NormalX[i], row.NormalY[i], row.NormalZ[i]);
            if (Vector3D.Dot(normal, light - point) > 0.0)
            {
                (row.NormalX[i], row.NormalY[i], row.NormalZ[i]) =
                    Smooth(scratch.Normals, visible.FacetOf(y, row.Facets[i]), normal, point, visible.View.Camera.PositionMoonMe);
            }
        }
    }

    /// <summary>At the limb a normal between the samples can look away from the camera, where no law has a value: there the facet's own is left.</summary>
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
