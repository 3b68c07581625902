namespace Msisf.Core.Certainty;

/// <summary>
/// A cosine, or a haversine, of an angle of light or view on a facet, as it changes with the heights of the facet's corners and with the
/// directions to Sun and camera: linear in these, and a rest.
/// </summary>
/// <param name="Middle">Its value as it is drawn.</param>
/// <param name="Rest">By how much the linear part is off at most.</param>
internal readonly record struct AngleForm(double Middle, double Rest)
{
    /// <summary>Its change where each corner is as high as it may be.</summary>
    public Vector3D ByHeights { get; init; }

    /// <summary>Its gradient by the direction to the Sun, across that.</summary>
    public Vector3D BySun { get; init; }

    /// <summary>Its gradient by the direction to the camera, across that.</summary>
    public Vector3D ByView { get; init; }

    public static AngleForm operator *(double factor, in AngleForm form) =>
        new(factor * form.Middle, Math.Abs(factor) * form.Rest)
        {
            ByHeights = factor * form.ByHeights,
            BySun = factor * form.BySun,
            ByView = factor * form.ByView,
        };

    public static AngleForm operator +(in AngleForm a, in AngleForm b) => new(a.Middle + b.Middle, a.Rest + b.Rest)
    {
        ByHeights = a.ByHeights + b.ByHeights,
        BySun = a.BySun + b.BySun,
        ByView = a.ByView + b.ByView,
    };

    /// <summary>How far it can be from its middle.</summary>
    /// <param name="sun">By how much the direction to the Sun can change across itself.</param>
    /// <param name="view">The same for that to the camera.</param>
    public double Radius(double sun, double view) => Rest + Math.Abs(ByHeights.X) + Math.Abs(ByHeights.Y) + Math.Abs(ByHeights.Z)
        + (sun * BySun.Length) + (view * ByView.Length);
}
