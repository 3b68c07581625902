using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;

namespace Msisf.Core.Sensitivity;

/// <summary>Some rows of an image, drawn with several samples a pixel: sums up what their pixels' derivatives consist of.</summary>
/// <param name="samples">The samples of the rows as an image: a grid that includes the pixels' corners.</param>
/// <param name="tracer">Finds what casts a shadow.</param>
/// <param name="cornersOf">The corners of a facet, m, body-fixed.</param>
/// <param name="camera">The camera of the image.</param>
/// <param name="strip">The rows.</param>
/// <param name="options">How the samples were drawn.</param>
internal sealed class SampledStrip(
    IGroundTruth samples, ITerrainTracer tracer, Func<FacetId, (Vector3D A, Vector3D B, Vector3D C)> cornersOf,
    FrameCamera camera, PixelRows strip, NativeRenderOptions options)
{
    private const int PerAxis = SensitivityFinder.SamplesPerAxis;

    /// <summary>Finds the derivatives of some of the strip's rows.</summary>
    /// <param name="rows">Rows of the image.</param>
    /// <param name="field">Receives the derivatives.</param>
    public void Find(PixelRows rows, SensitivityField field)
    {
        int height = rows.End - rows.First;
        PixelSums[] sums = new PixelSums[height * camera.Width];
        ImageScale[] scales = ScalesOf(rows);
        ShadowMotion shadows = new(tracer, cornersOf, camera, samples.Light);
        GroundSlopes slopes = new(samples, options);
        SampleLine above = new(samples);
        SampleLine line = new(samples);
        int first = (rows.First - strip.First) * PerAxis;
        for (int step = 0; step <= height * PerAxis; step++)
        {
            line.Read(first + step);
            slopes.Find(line);
            (int row, int inPixel) = Math.DivRem(step, PerAxis);

            // A line on the border of two rows of pixels counts half in each.
            if (inPixel == 0 && row > 0)
            {
                Add(row - 1, 0.5);
            }

            if (row < height)
            {
                Add(row, inPixel == 0 ? 0.5 : 1.0);
            }

            if (step > 0)
            {
                int between = (step - 1) / PerAxis;
                AddAcross(above, line, shadows, RowOf(sums, between), RowOf(scales, between));
            }

            (above, line) = (line, above);
        }

        for (int i = 0; i < sums.Length; i++)
        {
            Put(in sums[i], in scales[i], shadows, i % camera.Width, rows.First + (i / camera.Width), field);
        }

        void Add(int row, double weight)
        {
            AddAlong(line, shadows, RowOf(sums, row), RowOf(scales, row), weight);
            slopes.Add(line, RowOf(sums, row), weight);
        }

        Span<T> RowOf<T>(T[] pixels, int row) => pixels.AsSpan(row * camera.Width, camera.Width);
    }

    private ImageScale[] ScalesOf(PixelRows rows)
    {
        ImageScale[] scales = new ImageScale[(rows.End - rows.First) * camera.Width];
        for (int row = rows.First; row < rows.End; row++)
        {
            for (int column = 0; column < camera.Width; column++)
            {
                scales[((row - rows.First) * camera.Width) + column] = ImageScale.At(camera.Model, column + 1.0, row + 1.0);
            }
        }

        return scales;
    }

    /// <summary>Adds what changes from left to right along a line of samples.</summary>
    /// <param name="weight">Weight of the line in the pixels.</param>
    private static void AddAlong(
        SampleLine line, ShadowMotion shadows, Span<PixelSums> sums, ReadOnlySpan<ImageScale> scales, double weight)
    {
        ReadOnlySpan<double> light = line.Light;
        double[] nearness = line.Nearness;
        double[] visible = line.Visible;
        for (int column = 0; column < sums.Length; column++)
        {
            ref PixelSums pixel = ref sums[column];
            int first = column * PerAxis;
            for (int sample = first; sample < first + PerAxis; sample++)
            {
                double change = weight * (light[sample + 1] - light[sample]);
                if (change == 0.0)
                {
                    continue;
                }

                pixel.Right += change;
                pixel.RightByDepth += change * Math.Max(nearness[sample], nearness[sample + 1]);
                if (visible[sample] != visible[sample + 1])
                {
                    ShadowChange moved = shadows.Between(line, sample, line, sample + 1, in scales[column]);
                    pixel.SunEast -= weight * moved.EastX;
                    pixel.SunNorth -= weight * moved.NorthX;
                }
            }
        }
    }

    /// <summary>Adds what changes from a line of samples to the one below.</summary>
    private static void AddAcross(
        SampleLine above, SampleLine below, ShadowMotion shadows, Span<PixelSums> sums, ReadOnlySpan<ImageScale> scales)
    {
        ReadOnlySpan<double> upper = above.Light;
        ReadOnlySpan<double> lower = below.Light;
        for (int column = 0; column < sums.Length; column++)
        {
            ref PixelSums pixel = ref sums[column];
            int first = column * PerAxis;
            for (int sample = first; sample <= first + PerAxis; sample++)
            {
                double weight = sample == first || sample == first + PerAxis ? 0.5 : 1.0;
                double change = weight * (lower[sample] - upper[sample]);
                if (change == 0.0)
                {
                    continue;
                }

                pixel.Down += change;
                pixel.DownByDepth += change * Math.Max(above.Nearness[sample], below.Nearness[sample]);
                if (above.Visible[sample] != below.Visible[sample])
                {
                    ShadowChange moved = shadows.Between(above, sample, below, sample, in scales[column]);
                    pixel.SunEast -= weight * moved.EastY;
                    pixel.SunNorth -= weight * moved.NorthY;
                }
            }
        }
    }

    /// <summary>Puts together the derivatives of a pixel.</summary>
    private void Put(in PixelSums sums, in ImageScale scale, ShadowMotion shadows, int column, int row, SensitivityField field)
    {
        int at = (row * camera.Width) + column;
        const double PerSample = 1.0 / (PerAxis * PerAxis);
        double right = sums.Right / PerAxis;
        double down = sums.Down / PerAxis;
        double rightByDepth = sums.RightByDepth / PerAxis;
        double downByDepth = sums.DownByDepth / PerAxis;

        // The image moves by the scale times a change of the tangents; brightness at a place of the image falls by its slope times that.
        double byRight = -((right * scale.XByRight) + (down * scale.YByRight));
        double byDown = -((right * scale.XByDown) + (down * scale.YByDown));
        double nearByRight = -((rightByDepth * scale.XByRight) + (downByDepth * scale.YByRight));
        double nearByDown = -((rightByDepth * scale.XByDown) + (downByDepth * scale.YByDown));
        (double a, double b) = (scale.Right, scale.Down);
        Vector3D seen = camera.MoonFromCamera.Conjugate * (PerSample * sums.ByCamera);
        double[][] planes = field.Planes;
        planes[0][at] = seen.X - (a * nearByRight) - (b * nearByDown);
        planes[1][at] = seen.Y - nearByRight;
        planes[2][at] = seen.Z + nearByDown;
        planes[3][at] = (-b * byRight) + (a * byDown);
        planes[4][at] = (a * b * byRight) + ((1.0 + (b * b)) * byDown);
        planes[5][at] = ((1.0 + (a * a)) * byRight) + (a * b * byDown);
        planes[6][at] = -((right * (column + 1.0 - camera.Model.PrincipalX)) + (down * (row + 1.0 - camera.Model.PrincipalY)))
            / camera.Model.FocalX;
        planes[7][at] = -right;
        planes[8][at] = -down;
        planes[9][at] = (sums.SunEast / PerAxis) + (PerSample * Vector3D.Dot(sums.BySun, shadows.East));
        planes[10][at] = (sums.SunNorth / PerAxis) + (PerSample * Vector3D.Dot(sums.BySun, shadows.North));
        planes[11][at] = PerSample * sums.Light;
    }
}

/// <summary>Sums over the samples of a pixel and over the changes between them.</summary>
internal struct PixelSums
{
    /// <summary>I/F.</summary>
    public double Light;

    /// <summary>Change of I/F to the right.</summary>
    public double Right;

    /// <summary>Change of I/F down.</summary>
    public double Down;

    /// <summary>1/m: change to the right over the depth of the nearer sample.</summary>
    public double RightByDepth;

    /// <summary>1/m: change down over the depth of the nearer sample.</summary>
    public double DownByDepth;

    /// <summary>1/rad: what shadows lose where the Sun moves east.</summary>
    public double SunEast;

    /// <summary>1/rad: what shadows lose where the Sun moves north.</summary>
    public double SunNorth;

    /// <summary>1/m, body-fixed: gradient of I/F of the ground by the camera's position.</summary>
    public Vector3D ByCamera;

    /// <summary>1/rad, body-fixed: gradient of I/F of the ground by the direction to the Sun.</summary>
    public Vector3D BySun;
}

/// <summary>How a place of the image moves with its tangents.</summary>
/// <param name="Right">Tangent to the right of the optical axis.</param>
/// <param name="Down">Tangent below it.</param>
/// <param name="XByRight">px.</param>
/// <param name="YByRight">px.</param>
/// <param name="XByDown">px.</param>
/// <param name="YByDown">px.</param>
internal readonly record struct ImageScale(
    double Right, double Down, double XByRight, double YByRight, double XByDown, double YByDown)
{
    /// <summary>At a place in rendering coordinates.</summary>
    public static ImageScale At(CameraModel model, double x, double y)
    {
        (double right, double down) = model.ToIdeal(x, y);
        (double xByRight, double yByRight) = model.DirectionInImage((right, down), 1.0, 0.0);
        (double xByDown, double yByDown) = model.DirectionInImage((right, down), 0.0, 1.0);
        return new ImageScale(right, down, xByRight, yByRight, xByDown, yByDown);
    }
}
