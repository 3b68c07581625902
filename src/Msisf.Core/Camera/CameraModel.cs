using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera.Lenses;

namespace Msisf.Core.Camera;

/// <summary>
/// A camera without its position: image size, focal length, principal point, skew and distortion. Points of the image are in rendering
/// coordinates (<see cref="RenderingPoint"/>); points of the ideal image plane are tangents, right and down from the optical axis.
/// Immutable.
/// </summary>
public sealed class CameraModel
{
    /// <summary>Degrees: fields of view as wide as this, or wider, are refused where a camera has a lens.</summary>
    public const double MaxFieldDegrees = 170.0;

    private static readonly double MaxTangent = Math.Tan(MaxFieldDegrees * Math.PI / 360.0);

    private KeptWindow? _window; // the last one

    /// <summary>Describes a camera.</summary>
    /// <param name="width">Image width, px, at least 1.</param>
    /// <param name="height">Image height, px, at least 1.</param>
    /// <param name="focal">Focal length along rows and columns, px, above 0.</param>
    /// <param name="principal">Where the optical axis meets the image, rendering coordinates; may lie outside the image.</param>
    /// <param name="skew">px: the element of the first row and second column of the camera matrix.</param>
    /// <param name="distortion">The lens; null for a pinhole.</param>
    /// <exception cref="BadInputException">
    /// The field of view is too narrow or reaches <see cref="MaxFieldDegrees"/>, or the distortion has no inverse somewhere in the image.
    /// </exception>
    public CameraModel(
        int width, int height, (double X, double Y) focal, (double X, double Y) principal, double skew = 0.0, Distortion? distortion = null)
        : this(width, height, focal, principal, skew, 0.0, isThesis: false)
    {
        Distortion = distortion is null or { IsNone: true } ? null : distortion;
        if (Distortion is not null)
        {
            Lens = LensMap.TryCreate(Distortion, MeasuredBorders(), out (double X, double Y) failed)
                ?? throw new BadInputException(NoInverse(failed));
        }

        (double leftX, _) = ToIdeal(0.5, 0.5 * (1.0 + height));
        (double rightX, _) = ToIdeal(width + 0.5, 0.5 * (1.0 + height));
        FieldOfView = Trigonometry.Atan2(rightX - leftX, 1.0 + (leftX * rightX));
        RequireField();
    }

    private CameraModel(
        int width, int height, (double X, double Y) focal, (double X, double Y) principal, double skew, double fieldOfView, bool isThesis)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);
        Width = width;
        Height = height;
        (FocalX, FocalY) = (Guard.Positive(focal.X, "the focal length in px"), Guard.Positive(focal.Y, "the focal length in px"));
        (PrincipalX, PrincipalY) = (Guard.Finite(principal.X, "the principal point"), Guard.Finite(principal.Y, "the principal point"));
        Skew = Guard.Finite(skew, "the skew");
        FieldOfView = fieldOfView;
        IsThesis = isThesis;
    }

    /// <summary>Cuts a part out of an image.</summary>
    private CameraModel(CameraModel whole, int left, int top, int width, int height)
        : this(
            width, height, (whole.FocalX, whole.FocalY), (whole.PrincipalX - left, whole.PrincipalY - top), whole.Skew, whole.FieldOfView,
            isThesis: false)
    {
        (Distortion, Lens) = (whole.Distortion, whole.Lens);
    }

    /// <summary>Image width, px.</summary>
    public int Width { get; }

    /// <summary>Image height, px.</summary>
    public int Height { get; }

    /// <summary>Focal length along rows, px.</summary>
    public double FocalX { get; }

    /// <summary>Focal length along columns, px.</summary>
    public double FocalY { get; }

    /// <summary>Where the optical axis meets the image, to the right, rendering coordinate.</summary>
    public double PrincipalX { get; }

    /// <summary>Where the optical axis meets the image, down, rendering coordinate.</summary>
    public double PrincipalY { get; }

    /// <summary>px: how far a point of tangent 1 below the axis is shifted to the right.</summary>
    public double Skew { get; }

    /// <summary>The distortion of the lens; null for a pinhole.</summary>
    public Distortion? Distortion { get; }

    /// <summary>
    /// Horizontal field of view, rad: between the borders of the middle row; of a <see cref="Window"/> that of the whole.
    /// </summary>
    public double FieldOfView { get; }

    /// <summary>Whether this is the thesis's camera: square pixels, the optical axis through the middle, no distortion.</summary>
    internal bool IsThesis { get; }

    /// <summary>The lens; null for a pinhole.</summary>
    internal LensMap? Lens { get; }

    /// <summary>The thesis's camera.</summary>
    /// <param name="fieldOfView">Horizontal field of view, rad, from <see cref="Tolerances.MinFieldOfView"/> to below pi.</param>
    /// <param name="width">Image width, px, at least 1.</param>
    /// <param name="height">Image height, px, at least 1.</param>
    /// <exception cref="BadInputException">The field of view is out of range.</exception>
    public static CameraModel FromFieldOfView(double fieldOfView, int width, int height)
    {
        if (!(fieldOfView >= Tolerances.MinFieldOfView && fieldOfView < Math.PI))
        {
            throw new BadInputException(
                $"The field of view is {Degrees(fieldOfView)} degrees; it must lie between {Degrees(Tolerances.MinFieldOfView)} and 180 "
                    + $"degrees.");
        }

        double focal = width / (2.0 * Math.Tan(fieldOfView / 2.0));
        return new CameraModel(
            width, height, (focal, focal), (0.5 * (1.0 + width), 0.5 * (1.0 + height)), 0.0, fieldOfView, isThesis: true);
    }

    /// <summary>The same camera as the thesis's camera if it is one, so that its images have the same bytes; otherwise this one.</summary>
    public CameraModel Simplified() =>
        Lens is null && Skew == 0.0 && FocalX == FocalY
            && PrincipalX == 0.5 * (1.0 + Width) && PrincipalY == 0.5 * (1.0 + Height)
            ? FromFieldOfView(2.0 * Math.Atan(0.5 * Width / FocalX), Width, Height)
            : this;

    /// <summary>Places the camera.</summary>
    /// <exception cref="BadInputException">The position's length is not finite.</exception>
    /// <exception cref="ArgumentException">The orientation is <c>default</c>, which is not a rotation.</exception>
    public FrameCamera At(CameraState state) => Lens is null ? new PinholeCamera(state, this) : new LensCamera(state, this);

    /// <summary>The camera of a part of this one's image, or of more, in which each pixel shows what it shows in the whole.</summary>
    /// <param name="left">Columns of the whole to the left of it; negative where it reaches farther than the whole.</param>
    /// <param name="top">Rows of the whole above it.</param>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    /// <returns>The same object as at the last call for the same part, so that what depends on the camera alone can be kept.</returns>
    /// <exception cref="BadInputException">The camera can't be drawn so far beyond its borders.</exception>
    public CameraModel Window(int left, int top, int width, int height)
    {
        KeptWindow? kept = _window;
        if (kept is null || (kept.Left, kept.Top, kept.Model.Width, kept.Model.Height) != (left, top, width, height))
        {
            _window = kept = new KeptWindow(left, top, Cut(left, top, width, height));
        }

        return kept.Model;
    }

    /// <summary>The point of the ideal image plane that a point of the image shows.</summary>
    public (double Right, double Down) ToIdeal(double x, double y)
    {
        LanePoints ideal = ToIdeal(Vector512.Create(x), Vector512.Create(y));
        return (ideal.X[0], ideal.Y[0]);
    }

    /// <summary>The points of the ideal image plane that eight points of the image show; each has the bits of the point alone.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    internal LanePoints ToIdeal(Vector512<double> x, Vector512<double> y)
    {
        Vector512<double> down = (y - Vector512.Create(PrincipalY)) / Vector512.Create(FocalY);
        Vector512<double> right = (x - Vector512.Create(PrincipalX) - (Skew * down)) / Vector512.Create(FocalX);
        LanePoints measured = new(right, down);
        return Lens is null ? measured : Lens.ToIdeal(measured);
    }

    /// <summary>
    /// The point of the image in which a point of the ideal image plane is seen; any value outside the image is possible.
    /// </summary>
    /// <param name="right">Tangent to the right of the optical axis.</param>
    /// <param name="down">Tangent below it.</param>
    /// <returns>False if the lens does not show it.</returns>
    public bool TryToImage(double right, double down, out RenderingPoint point)
    {
        (double x, double y) = (right, down);
        if (Lens is not null)
        {
            if (!Lens.TryToMeasured(LanePoints.All(right, down), out LanePoints measured, out _))
            {
                point = default;
                return false;
            }

            (x, y) = (measured.X[0], measured.Y[0]);
        }

        point = new RenderingPoint(PrincipalX + (FocalX * x) + (Skew * y), PrincipalY + (FocalY * y));
        return double.IsFinite(point.X) && double.IsFinite(point.Y);
    }

    /// <summary>How a direction in the ideal image plane appears in the image.</summary>
    /// <param name="at">The point, as tangents.</param>
    /// <returns>The direction in the image, of another length.</returns>
    internal (double Right, double Down) DirectionInImage((double Right, double Down) at, double right, double down)
    {
        (double x, double y) = (right, down);
        if (Lens is not null)
        {
            _ = Lens.TryToMeasured(LanePoints.All(at.Right, at.Down), out _, out LaneSlopes slopes);
            x = (slopes.Xx[0] * right) + (slopes.Xy[0] * down);
            y = (slopes.Yx[0] * right) + (slopes.Yy[0] * down);
        }

        return ((FocalX * x) + (Skew * y), FocalY * y);
    }

    /// <summary>Area of a pixel in the ideal image plane.</summary>
    /// <param name="at">Its place there, as tangents.</param>
    internal double PixelArea((double Right, double Down) at)
    {
        double area = 1.0 / (FocalX * FocalY);
        if (Lens is not null)
        {
            _ = Lens.TryToMeasured(LanePoints.All(at.Right, at.Down), out _, out LaneSlopes slopes);
            area /= slopes.Determinant[0];
        }

        return area;
    }

    /// <summary>Tangent of the angle that a pixel covers, where it is smallest in the ideal image plane.</summary>
    internal double MinPixelTangent()
    {
        // The singular values of the camera matrix's upper left part.
        double sum = double.Hypot(FocalX + FocalY, Skew);
        double difference = double.Hypot(FocalX - FocalY, Skew);
        return (Lens?.MinScale ?? 1.0) / (0.5 * (sum + difference));
    }

    /// <summary>Maximum tangent of the angle from the optical axis to a border of the image.</summary>
    internal double BorderTangent()
    {
        if (Lens is not null)
        {
            return Lens.MaxTangent;
        }

        double max = 0.0;
        foreach ((double x, double y) in (ReadOnlySpan<(double, double)>)[
            (0.5, 0.5), (Width + 0.5, 0.5), (0.5, Height + 0.5), (Width + 0.5, Height + 0.5)])
        {
            (double right, double down) = ToIdeal(x, y);
            max = Math.Max(max, double.Hypot(right, down));
        }

        return max;
    }

    private CameraModel Cut(int left, int top, int width, int height) =>
        (left, top, width, height) == (0, 0, Width, Height) ? this
        : left >= 0 && top >= 0 && left + width <= Width && top + height <= Height
            ? new CameraModel(this, left, top, width, height)
            : new CameraModel(width, height, (FocalX, FocalY), (PrincipalX - left, PrincipalY - top), Skew, Distortion).Simplified();

    private void RequireField()
    {
        if (!(BorderTangent() < MaxTangent))
        {
            throw new BadInputException(Invariant(
                $"the image shows directions {MaxFieldDegrees / 2.0:F0} degrees or more from the optical axis; the field of view must stay "
                    + $"below {MaxFieldDegrees:F0} degrees. Take a longer focal length or a smaller image"));
        }

        if (!(FieldOfView >= Tolerances.MinFieldOfView))
        {
            throw new BadInputException(
                $"the field of view is {Degrees(FieldOfView)} degrees; at least {Degrees(Tolerances.MinFieldOfView)} degrees are needed.");
        }
    }

    /// <summary>The borders of the image in the measured plane; with skew of a rectangle around it.</summary>
    private (double Left, double Top, double Right, double Bottom) MeasuredBorders()
    {
        double top = (0.5 - PrincipalY) / FocalY;
        double bottom = (Height + 0.5 - PrincipalY) / FocalY;
        double shift = Skew / FocalX;
        double left = ((0.5 - PrincipalX) / FocalX) - Math.Max(shift * top, shift * bottom);
        double right = ((Width + 0.5 - PrincipalX) / FocalX) - Math.Min(shift * top, shift * bottom);
        return (left, top, right, bottom);
    }

    private string NoInverse((double X, double Y) measured)
    {
        double x = Math.Clamp(Math.Round(PrincipalX + (FocalX * measured.X) + (Skew * measured.Y)), 1.0, Width);
        double y = Math.Clamp(Math.Round(PrincipalY + (FocalY * measured.Y)), 1.0, Height);
        return Invariant(
            $"these coefficients do not invert inside the image: pixel ({x}, {y}) shows no direction, or the image folds on the way there");
    }

    private static string Degrees(double angle) =>
        double.RadiansToDegrees(angle).ToString("R", CultureInfo.InvariantCulture);

    private sealed record KeptWindow(int Left, int Top, CameraModel Model);
}
