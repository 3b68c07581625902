using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera.Lenses;

/// <summary>Eight points of the image plane, in units of the focal length, x to the right and y down, from the principal point.</summary>
internal readonly record struct LanePoints(Vector512<double> X, Vector512<double> Y)
{
    /// <summary>The same point eight times.</summary>
    public static LanePoints All(double x, double y) => new(Vector512.Create(x), Vector512.Create(y));
}
