using Msisf.Core.Camera;

namespace Msisf.Core.Navigation;

/// <summary>A crater in an image.</summary>
/// <param name="Disc">Its disc, m, body-fixed.</param>
/// <param name="Ellipse">How its rim is seen.</param>
public sealed record CraterView(Crater Crater, CraterDisc Disc, ImageEllipse Ellipse)
{
    /// <summary>Points of the rim in the image if it is not an ellipse: through a lens, or on the terrain. Empty if it is.</summary>
    public IReadOnlyList<RenderingPoint> Curve { get; init; } = [];

    /// <summary>px: root mean square distance of <see cref="Curve"/> from <see cref="Ellipse"/>; null without a curve.</summary>
    public double? Residual { get; init; }

    /// <summary>
    /// Covariance of centre x, y, semi-major and semi-minor axis (px) and angle (rad), by rows; null where the catalogue has no errors, or
    /// the ellipse is so near to a circle that it has no angle.
    /// </summary>
    public IReadOnlyList<double>? Covariance { get; init; }

    /// <summary>Part of the ellipse that lies inside the image, 0 to 1.</summary>
    public required double Inside { get; init; }

    /// <summary>rad at the centre of the disc, from its normal to the camera.</summary>
    public required double Emission { get; init; }

    /// <summary>rad at the centre of the disc, from its normal to the light.</summary>
    public required double Incidence { get; init; }

    /// <summary>
    /// Part of the ellipse inside the image, 0 to 1, where terrain hides the disc (<see cref="CraterDisc.IsHiddenBy"/>); null if the
    /// ellipse holds no pixel.
    /// </summary>
    public double? Hidden { get; init; }

    /// <summary>Part of what the image shows of the crater that is lit, 0 to 1; null if it shows nothing of it.</summary>
    public double? Lit { get; init; }

    /// <summary>px.</summary>
    public double Diameter => 2.0 * Ellipse.SemiMajor;
}

/// <summary>A crater that an image shows some of, but not as an ellipse.</summary>
/// <param name="Reason">Why.</param>
public sealed record CraterLeftOut(Crater Crater, CraterLeftOutReason Reason);

/// <summary>Why a crater is left out.</summary>
public enum CraterLeftOutReason
{
    /// <summary>The rim crosses the plane of the camera, so that it is seen as a hyperbola.</summary>
    Hyperbola,

    /// <summary>The lens does not show all of the rim, or no ellipse fits what it shows.</summary>
    NoEllipse,
}

/// <summary>The craters of a frame.</summary>
/// <param name="Views">Those in view, in the order of the catalogue.</param>
/// <param name="LeftOut">Those in view that are not ellipses.</param>
/// <param name="TooSmall">How many more are in view, smaller than the least diameter.</param>
public sealed record CratersOfFrame(IReadOnlyList<CraterView> Views, IReadOnlyList<CraterLeftOut> LeftOut, int TooSmall)
{
    /// <summary>Where the rims were taken to lie.</summary>
    public required CraterRim Rim { get; init; }

    /// <summary>px: the least diameter.</summary>
    public required double LeastDiameter { get; init; }
}

/// <summary>Where the rim of a crater is taken to lie.</summary>
public enum CraterRim
{
    /// <summary>On the disc in the plane through the centre of the crater.</summary>
    Disc,

    /// <summary>On the highest ground around the crater.</summary>
    Terrain,
}
