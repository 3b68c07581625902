using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;
using Msisf.Stress.Camera;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Stress.Tests.Camera;

/// <summary>
/// A camera 1.55 m over the ground whose ray grazes a vertex of LDEM_4. To 30 digits it enters two of the vertex's facets, 3e-12 m after
/// each other.
/// </summary>
public sealed class FacetJudgeTests
{
    private static readonly FacetId First = new(54, 493, FacetHalf.SouthWest);

    private static readonly FacetId Second = new(54, 494, FacetHalf.SouthWest);

    private static readonly Ray Grazing = new CameraInput(
        new Vector3D(-229384.1934470395, 346134.720664758, 1685965.7354128533),
        UnitQuaternion.FromComponents(0.9607027153986621, -0.2374716598211189, 0.057217102970968645, 0.13184728489828462),
        0.01354002985944292,
        new PixelFrame(7275, 8, 7171, 1)).ToCamera().RayThrough(7171, 1);

    [RequiresFact(Part.Ldem4)]
    public void IsWrong_TwoFacetsEnteredAtOnePoint_EitherIsRight()
    {
        FacetJudge judge = FacetJudge.OfRealModel();
        SurfaceHit hit = judge.Trace(Grazing)!.Value;

        Assert.Contains(hit.Facet, new[] { First, Second });
        Assert.False(judge.IsWrong(Grazing, hit with { Facet = First }));
        Assert.False(judge.IsWrong(Grazing, hit with { Facet = Second }));
    }

    [RequiresFact(Part.Ldem4)]
    public void IsWrong_FacetBesideTheRayOrNone_IsWrong()
    {
        FacetJudge judge = FacetJudge.OfRealModel();
        SurfaceHit hit = judge.Trace(Grazing)!.Value;

        Assert.True(judge.IsWrong(Grazing, null));
        Assert.True(judge.IsWrong(Grazing, hit with { Facet = new FacetId(54, 495, FacetHalf.SouthWest) }));
        Assert.True(judge.IsWrong(Grazing, hit with { PointBodyFixed = new Vector3D(double.NaN, 0.0, 0.0) }));
    }
}
