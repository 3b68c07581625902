using Msisf.Core.Camera;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tiles.Selection;

/// <summary>What lies in the image: the four-sided pyramid of the camera's rays, somewhat wider all around.</summary>
internal sealed class FramePyramid
{
    private readonly Vector3D _camera;
    private readonly Vector3D[] _inward;
    private readonly Vector3D[] _edges;

    /// <param name="camera">The camera.</param>
    /// <param name="marginPixels">So much wider on each side: a pixel for antialiasing's jitter, more where the surface that is drawn may differ from the model's.</param>
    /// <param name="rows">The rows that matter; null for the whole image.</param>
    public FramePyramid(PinholeCamera camera, double marginPixels, PixelRows? rows = null)
    {
        _camera = camera.PositionMoonMe;
        double focalLength = camera.Direction.Length;
        double right = camera.Right.Length / (2.0 * focalLength) * (1.0 + (2.0 * marginPixels / camera.Width));
        double halfHeight = camera.Up.Length / (2.0 * focalLength);
        PixelRows wanted = rows ?? new PixelRows(0, camera.Height);
        double top = halfHeight * (1.0 - (2.0 * (wanted.First - marginPixels) / camera.Height));
        double bottom = halfHeight * (1.0 - (2.0 * (wanted.End + marginPixels) / camera.Height));
        Vector3D forward = camera.ForwardMoonMe;
        Vector3D unitRight = camera.Right.Normalized();
        Vector3D unitUp = camera.Up.Normalized();
        _inward =
        [
            ((right * forward) + unitRight).Normalized(),
            ((right * forward) - unitRight).Normalized(),
            (unitUp - (bottom * forward)).Normalized(),
            ((top * forward) - unitUp).Normalized(),
        ];
        _edges =
        [
            forward + (right * unitRight) + (top * unitUp),
            forward + (right * unitRight) + (bottom * unitUp),
            forward - (right * unitRight) + (top * unitUp),
            forward - (right * unitRight) + (bottom * unitUp),
        ];
        Middle = (forward + (0.5 * (top + bottom) * unitUp)).Normalized();
    }

    /// <summary>Direction of the middle of the rows, MOON_ME.</summary>
    public Vector3D Middle { get; }

    /// <summary>Directions of the four edges, MOON_ME.</summary>
    public ReadOnlySpan<Vector3D> Edges => _edges;

    /// <summary>Whether a direction from the camera is in the image.</summary>
    public bool Holds(Vector3D direction)
    {
        foreach (Vector3D inward in _inward)
        {
            if (Vector3D.Dot(inward, direction) < 0.0)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Where a node lies, by the sphere about it.</summary>
    public FrameSide Classify(in TerrainNode node)
    {
        (Vector3D middle, double radius) = node.Ball();
        Vector3D centre = middle - _camera;
        FrameSide side = FrameSide.Inside;
        foreach (Vector3D inward in _inward)
        {
            double distance = Vector3D.Dot(inward, centre);
            if (distance < -radius)
            {
                return FrameSide.Outside;
            }

            if (distance < radius)
            {
                side = FrameSide.Straddling;
            }
        }

        return side;
    }

    /// <summary>Cuts off what is outside the image.</summary>
    /// <param name="polygon">Corners, m, MOON_ME; convex. Holds the result, which can have four corners more.</param>
    /// <param name="count">Corners before; after: 0 if nothing is in the image.</param>
    public void Clip(Span<Vector3D> polygon, ref int count)
    {
        Span<Vector3D> cut = stackalloc Vector3D[polygon.Length];
        foreach (Vector3D inward in _inward)
        {
            int kept = 0;
            for (int corner = 0; corner < count; corner++)
            {
                Vector3D here = polygon[corner];
                Vector3D next = polygon[corner + 1 == count ? 0 : corner + 1];
                double distance = Vector3D.Dot(inward, here - _camera) + Tolerances.VertexLattice;
                double nextDistance = Vector3D.Dot(inward, next - _camera) + Tolerances.VertexLattice;
                if (distance >= 0.0)
                {
                    cut[kept++] = here;
                }

                if ((distance >= 0.0) != (nextDistance >= 0.0))
                {
                    cut[kept++] = here + (distance / (distance - nextDistance) * (next - here));
                }
            }

            cut[..kept].CopyTo(polygon);
            count = kept;
            if (count == 0)
            {
                return;
            }
        }
    }
}
