using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Stress.Camera;

/// <summary>Inputs at the border of what a camera may be: just allowed, they give finite numbers; just not, one clear line.</summary>
/// <param name="terrain">The model.</param>
internal sealed class BorderCases(TerrainUnderTest terrain)
{
    private static readonly double[] NoNumbers = [double.NaN, double.PositiveInfinity, double.NegativeInfinity];
    private static readonly double[] NoFields = [0.0, -0.0, -1.0, 9e-13, Math.PI, 4.0, double.MaxValue, .. NoNumbers];
    private static readonly double[] Fields = [Tolerances.MinFieldOfView, 1e-9, Math.PI / 2.0, 3.14, Math.BitDecrement(Math.PI)];
    private static readonly double[] Distances =
    [
        0.0, 1e-300, 1.0, 1e6, Math.BitDecrement(MoonConstants.ReferenceRadius), MoonConstants.ReferenceRadius,
        Math.BitIncrement(MoonConstants.ReferenceRadius), 2e6, 1e12, 1e15, 1e30, 1e100, 1e153, 1e160, 1e200, 1e290, 1e300,
    ];

    private static readonly (
        int Width, int Height)[] Sizes = [(1, 1), (1, 16384), (16384, 1), (16384, 16384), (int.MaxValue, 1), (1, int.MaxValue)];

    /// <summary>How many there are.</summary>
    public int Count => Allowed().Count() + Refused().Count();

    /// <summary>Tries all.</summary>
    public IEnumerable<StressFigure> Figures()
    {
        CaseCount allowed = new();
        foreach (PinholeCamera camera in Allowed())
        {
            string? failure = FailureOf(camera);
            allowed.Note(
                failure is not null,
                () => $"camera {camera.PositionBodyFixed} FOV {camera.FieldOfView:R} rad {camera.Width} x {camera.Height} px: {failure}");
        }

        CaseCount refused = new();
        foreach ((string what, Action use) in Refused())
        {
            refused.Note(!IsRefused(use), () => what);
        }

        return
        [
            allowed.ToFigure("inputs at the border, allowed: refused, or a number that is not finite", string.Empty, 0.0),
            refused.ToFigure("inputs that are none: not refused by one clear line", string.Empty, 0.0),
        ];
    }

    private static IEnumerable<PinholeCamera> Allowed() =>
        from distance in Distances
        from up in new[] { Vector3D.UnitX, Vector3D.UnitZ, new Vector3D(0.6, 0.0, -0.8) }
        from field in Fields
        from size in Sizes
        from turn in new[] { 0.0, 0.5 * Math.PI, Math.PI }
        select new PinholeCamera(distance * up, UnitQuaternion.FromAxisAngle(Vector3D.UnitY, turn), field, size.Width, size.Height);

    private static bool IsRefused(Action use)
    {
        try
        {
            use();
            return false;
        }
        catch (MsisfException refusal)
        {
            return refusal.Message.Length > 0 && !refusal.Message.Contains('\n', StringComparison.Ordinal);
        }
        catch (ArgumentException)
        {
            return true; // sizes are checked where the user's options are read: here a wrong one is a bug
        }
    }

    private static PinholeCamera Camera(Vector3D position, double field = 0.7, int width = 64, int height = 64) =>
        new(position, UnitQuaternion.Identity, field, width, height);

    private string? FailureOf(PinholeCamera camera)
    {
        try
        {
            Ray ray = camera.RayThrough(1, camera.Height);
            bool isOnSphere = ReferenceSphere.Lola.TryFirstHit(ray, out Vector3D onSphere);
            bool isOnTerrain = terrain.Tracer.TryTrace(ray, out SurfaceHit hit);
            bool isRecord = new SpherePixels(
                camera, ReferenceSphere.Lola, new SceneLight(new Vector3D(1e11, 2e10, 3e9), IsSun: true))
                .TryGet(1, camera.Height, out PixelRecord record);
            bool isFinite = ray.Direction.IsFinite
                && (!isOnSphere || onSphere.IsFinite)
                && (!isOnTerrain || (hit.PointBodyFixed.IsFinite && hit.NormalBodyFixed.IsFinite && double.IsFinite(hit.RayParameter)))
                && (!isRecord || double.IsFinite(record.Point.Latitude + record.Point.Longitude + (record.IlluminationDirection ?? 0.0)));
            return isFinite ? null : $"not finite: {ray.Direction}, {onSphere}, {hit}, {record}";
        }
        catch (MsisfException refusal)
        {
            return refusal.Message;
        }
    }

    private IEnumerable<(string What, Action Use)> Refused()
    {
        Vector3D above = new(2e6, 0.0, 0.0);
        foreach (double field in NoFields)
        {
            yield return ($"FOV {field:R}", () => Camera(above, field));
        }

        foreach (int size in new[] { 0, -1, int.MinValue })
        {
            yield return ($"width {size}", () => Camera(above, width: size));
            yield return ($"height {size}", () => Camera(above, height: size));
        }

        foreach (double bad in NoNumbers)
        {
            yield return ($"x {bad}", () => Camera(new Vector3D(bad, 0.0, 0.0)));
            yield return ($"z {bad}", () => Camera(new Vector3D(0.0, 0.0, bad)));
            yield return ($"qx {bad}", () => UnitQuaternion.FromComponents(bad, 0.0, 0.0, 1.0));
            yield return ($"q0 {bad}", () => UnitQuaternion.FromComponents(0.0, 0.0, 0.0, bad));
            yield return ($"light {bad}", () => _ = new SpherePixels(
                Camera(above), ReferenceSphere.Lola, new SceneLight(new Vector3D(0.0, bad, 0.0), IsSun: true)));
            yield return ($"ray from {bad}", () => terrain.Tracer.TryTrace(new Ray(new Vector3D(0.0, bad, 0.0), Vector3D.UnitX), out _));
        }

        yield return ("quaternion 0", () => UnitQuaternion.FromComponents(0.0, 0.0, 0.0, 0.0));
        yield return ("quaternion of length 1.1", () => UnitQuaternion.FromComponents(0.0, 1.1, 0.0, 0.0));
        yield return ("ray without direction", () => terrain.Tracer.TryTrace(new Ray(above, default), out _));
        yield return ("camera in the centre", () => TerrainHeight.RequireAbove(terrain.Grid, default));
        yield return ("camera in the Moon", () => TerrainHeight.RequireAbove(terrain.Grid, new Vector3D(0.0, 0.0, 1.72e6)));
    }
}
