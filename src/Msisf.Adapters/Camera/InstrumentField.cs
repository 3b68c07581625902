using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;

namespace Msisf.Adapters.Camera;

/// <summary>The field of view of an instrument kernel, as NAIF's GETFOV has it.</summary>
/// <param name="prefix">E.g. "INS-77_".</param>
internal sealed class InstrumentField(KernelPool pool, string prefix)
{
    /// <summary>1: how far a corner may be from the image's, in parts of its width, to be one.</summary>
    private const double Tolerance = 1e-6;

    /// <summary>The lines of a camera file for a pinhole whose image is the field of view.</summary>
    /// <param name="axes">How the image lies in the instrument's frame.</param>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    /// <exception cref="BadInputException">It is not a rectangle along the image's axes, or keywords are missing.</exception>
    public string CameraText(InstrumentAxes axes, int width, int height)
    {
        Vector3D forward = Vector3D.Cross(axes.Right, axes.Down);
        (double X, double Y)[] corners =
        [
            .. Corners().Select(corner => Vector3D.Dot(corner, forward) is > 0.0 and double z
                ? (Vector3D.Dot(corner, axes.Right) / z, Vector3D.Dot(corner, axes.Down) / z)
                : throw Wrong("lies behind the camera whose image has these axes")),
        ];
        (double left, double right) = (corners.Min(corner => corner.X), corners.Max(corner => corner.X));
        (double top, double bottom) = (corners.Min(corner => corner.Y), corners.Max(corner => corner.Y));
        double limit = Tolerance * (right - left);
        bool isRectangle = corners.Length == 4 && corners.All(
            corner => Math.Min(corner.X - left, right - corner.X) <= limit && Math.Min(corner.Y - top, bottom - corner.Y) <= limit);
        if (!isRectangle || !(right > left && bottom > top))
        {
            throw Wrong("is not a rectangle along the image's axes");
        }

        (double focalX, double focalY) = (width / (right - left), height / (bottom - top));
        return Invariant(
            $"focal-length-px: [{focalX:R}, {focalY:R}]\nprincipal-point: [{0.5 - (left * focalX):R}, {0.5 - (top * focalY):R}]\n");
    }

    private Vector3D[] Corners()
    {
        if (Text("FOV_CLASS_SPEC") != "ANGLES")
        {
            double[] numbers = [.. (pool.Find(prefix + "FOV_BOUNDARY_CORNERS") ?? pool.Existing(prefix + "FOV_BOUNDARY")).Numbers];
            return [.. numbers.Chunk(3).Where(corner => corner.Length == 3).Select(Vector)];
        }

        if (Text("FOV_SHAPE") != "RECTANGLE")
        {
            throw Wrong("is no rectangle");
        }

        double unit = Text("FOV_ANGLE_UNITS") switch
        {
            "DEGREES" => Math.PI / 180.0,
            "RADIANS" => 1.0,
            "ARCMINUTES" => Math.PI / 10_800.0,
            "ARCSECONDS" => Math.PI / 648_000.0,
            string other => throw Wrong($"has angles in '{other}'; RADIANS, DEGREES, ARCMINUTES, ARCSECONDS are known"),
        };
        Vector3D axis = Vector("BORESIGHT").Normalized();
        Vector3D reference = Vector("FOV_REF_VECTOR");
        reference = (reference - (Vector3D.Dot(reference, axis) * axis)).Normalized();
        Vector3D alongReference = Math.Tan(unit * Number("FOV_REF_ANGLE")) * reference;
        Vector3D across = Math.Tan(unit * Number("FOV_CROSS_ANGLE")) * Vector3D.Cross(axis, reference);
        return
        [
            axis + alongReference + across, axis + alongReference - across, axis - alongReference - across, axis - alongReference + across,
        ];
    }

    private string Text(string item) => pool.Find(prefix + item)?.Texts is [string text] ? text.Trim().ToUpperInvariant() : string.Empty;

    private double Number(string item) => pool.Numbers(prefix + item, 1)[0];

    private Vector3D Vector(string item) => Vector([.. pool.Numbers(prefix + item, 3)]);

    private static Vector3D Vector(double[] numbers) => new(numbers[0], numbers[1], numbers[2]);

    private BadInputException Wrong(string what) => new(
        $"{pool.Existing(prefix + "FOV_SHAPE").Source}: the field of view {what}, and there is no {prefix}FOCAL_LENGTH. "
            + "Give the camera with --camera FILE instead.");
}
