namespace Msisf.Core.Camera;

/// <summary>
/// A rectangle of the ideal image plane: tangents of angles from the optical axis, to the right and down; may be infinite.
/// </summary>
internal readonly record struct TangentBox(double Left, double Top, double Right, double Bottom)
{
    /// <summary>Holds nothing; widen it by points.</summary>
    public static TangentBox Nothing =>
        new(double.PositiveInfinity, double.PositiveInfinity, double.NegativeInfinity, double.NegativeInfinity);

    /// <summary>The whole plane.</summary>
    public static TangentBox Everything =>
        new(double.NegativeInfinity, double.NegativeInfinity, double.PositiveInfinity, double.PositiveInfinity);

    /// <summary>Its area; infinite or NaN for one that is not bounded.</summary>
    public double Area => (Right - Left) * (Bottom - Top);

    /// <summary>The smallest rectangle that holds this one and a point.</summary>
    public TangentBox With(double right, double down) =>
        new(Math.Min(Left, right), Math.Min(Top, down), Math.Max(Right, right), Math.Max(Bottom, down));

    /// <summary>The smallest rectangle that holds this one and another.</summary>
    public TangentBox With(TangentBox other) => With(other.Left, other.Top).With(other.Right, other.Bottom);

    /// <summary>Whether the two have a point in common.</summary>
    public bool Meets(in TangentBox other) =>
        Left <= other.Right && other.Left <= Right && Top <= other.Bottom && other.Top <= Bottom;
}
