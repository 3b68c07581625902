using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Knows the pieces of facets that all of the light reaches as a whole or not at all, and over which no map changes much. Safe for
/// several threads.
/// </summary>
/// <param name="view">The projection of the frame.</param>
/// <param name="lightBodyFixed">The place of the light, m, body-fixed.</param>
/// <param name="light">Tells the light by the facets that face away; null for a light without shadows.</param>
/// <param name="evenDepth">m: up to this depth no map changes much over a pixel.</param>
internal sealed class SurePieces(ImageView view, Vector3D lightBodyFixed, SureLight? light, double evenDepth) : IPieces
{
    /// <summary>
    /// Planes that rays meet at a smaller sine are left to the single samples: there the points are not sure to a millimetre.
    /// </summary>
    private const double MinSine = 1e-4;

    private readonly Vector3D _camera = view.Camera.PositionBodyFixed;
    private readonly Vector3D _fromAnchor = view.Camera.PositionBodyFixed - view.Anchor;
    private readonly (Vector3D Middle, Vector3D Across, Vector3D Along) _axes = view.Camera.RayAxes;

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public bool IsEven(in FacetRecord facet, double inverseDepth, in TangentBox piece)
    {
        if (!(inverseDepth * evenDepth > 1.0))
        {
            return false;
        }

        if (light is null)
        {
            return true;
        }

        Vector256<double> across = Vector256.Create(piece.Left, piece.Right, piece.Left, piece.Right);
        Vector256<double> along = Vector256.Create(piece.Top, piece.Top, piece.Bottom, piece.Bottom);
        Vector256<double> x = Vector256.Create(_axes.Middle.X) + (across * _axes.Across.X) + (along * _axes.Along.X);
        Vector256<double> y = Vector256.Create(_axes.Middle.Y) + (across * _axes.Across.Y) + (along * _axes.Along.Y);
        Vector256<double> z = Vector256.Create(_axes.Middle.Z) + (across * _axes.Across.Z) + (along * _axes.Along.Z);
        Vector3D normal = facet.Normal;
        double square = normal.LengthSquared;
        Vector256<double> perRay = (normal.X * x) + (normal.Y * y) + (normal.Z * z);
        Vector256<double> length = (x * x) + (y * y) + (z * z);
        double height = facet.Offset - Vector3D.Dot(normal, _fromAnchor);
        if (!Vector256.LessThanAll(perRay, Vector256<double>.Zero) || !(height < 0.0)
            || !Vector256.GreaterThanAll(perRay * perRay, length * (MinSine * MinSine * square)))
        {
            return false;
        }

        Vector256<double> parameter = Vector256.Create(height) / perRay;
        x = Vector256.Create(_camera.X) + (parameter * x);
        y = Vector256.Create(_camera.Y) + (parameter * y);
        z = Vector256.Create(_camera.Z) + (parameter * z);
        Vector3D toSun = lightBodyFixed - new Vector3D(x[0], y[0], z[0]);
        double facing = Vector3D.Dot(normal, toSun);
        double least = light.LeastCosine;
        return facing * facing > least * least * square * toSun.LengthSquared
            && (facing < 0.0 || light.Of(x, y, z) != PieceLight.Unsure);
    }
}
