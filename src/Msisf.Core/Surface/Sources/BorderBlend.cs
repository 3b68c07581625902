using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// A window of invented detail whose heights go over, along its border, into the facets of the models. Safe for several threads.
/// </summary>
/// <remarks>
/// With d, the number of samples from a sample to the nearest one beyond the window, t = (d - 1) / width up to 1, and
/// w = t t (3 - 2 t), a radius is w times its own plus 1 - w times that of the models' facets in its direction. So the outermost
/// samples, for which d is 1, lie on the models' facets.
/// </remarks>
internal sealed class BorderBlend : ChangedGrid
{
    /// <summary>Samples of the width at least, so that the slope of a step is spread over some cells.</summary>
    private const int MinWidth = 8;

    private readonly CoarserGround _models;
    private readonly int _width;

    /// <summary>By line, m: the samples in the border, from the left; NaN for those that were not read yet.</summary>
    private readonly double[][] _blended;

    /// <summary>Prepares a window; nothing is read.</summary>
    public BorderBlend(DetailWindow window, CoarserGround models)
        : base(window)
    {
        _models = models;
        _width = WidthOf(window, models);
        (double min, double max) = models.RadiusLimits;
        RadiusLimits = (Math.Min(min, window.RadiusLimits.Min), Math.Max(max, window.RadiusLimits.Max));
        _blended = new double[Lines][];
        for (int line = 0; line < Lines; line++)
        {
            _blended[line] = new double[IsNearEnd(line, Lines) ? Samples : 2 * _width];
            Array.Fill(_blended[line], double.NaN);
        }
    }

    /// <inheritdoc/>
    public override (double Min, double Max) RadiusLimits { get; }

    /// <inheritdoc/>
    public override KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples) => null;

    /// <inheritdoc/>
    /// <remarks>Each sample is blended when it is first read, which costs a search in the models. Threads compute the same.</remarks>
    public override void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        Source.ReadRadii(line, firstSample, radii);
        double[] blended = _blended[line];
        for (int i = 0; i < radii.Length; i++)
        {
            int sample = firstSample + i;
            if (!IsBlended(line, sample))
            {
                continue;
            }

            ref double known = ref blended[sample < _width || blended.Length == Samples ? sample : sample - Samples + (2 * _width)];
            double radius = Volatile.Read(ref known);
            if (double.IsNaN(radius))
            {
                radius = Blend(line, sample, radii[i]);
                Volatile.Write(ref known, radius);
            }

            radii[i] = radius;
        }
    }

    /// <inheritdoc/>
    public override bool IsBlended(int line, int sample) => IsNearEnd(line, Lines) || IsNearEnd(sample, Samples);

    /// <summary>A cell of the models around the middle of the window, in the window's samples, within limits.</summary>
    private static int WidthOf(DetailWindow window, CoarserGround models)
    {
        Vector3D middle = window.Projection.DirectionOf(0.5 * (window.Lines - 1), 0.5 * (window.Samples - 1));
        double ratio = models.CellAngleAt(middle) * MoonConstants.ReferenceRadius / window.Projection.Resolution.MetresPerPixel;
        int width = Math.Clamp((int)Math.Ceiling(ratio), MinWidth, WindowPlan.WidestBorder);
        return Math.Clamp(Math.Min(window.Lines, window.Samples) / 4, 1, width);
    }

    private bool IsNearEnd(int place, int count) => place < _width || place >= count - _width;

    private double Blend(int line, int sample, double own)
    {
        int distance = Math.Min(Math.Min(line + 1, Lines - line), Math.Min(sample + 1, Samples - sample));
        double t = (distance - 1) / (double)_width;
        double weight = t * t * (3.0 - (2.0 * t));
        return (weight * own) + ((1.0 - weight) * _models.RadiusAt(Projection.DirectionOf(line, sample)));
    }
}
