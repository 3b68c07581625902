namespace Msisf.Core.Terrain;

/// <summary>
/// A map that is moved over the ground. A polar map's samples lie at other places; in a map of latitude and longitude, whose samples have
/// their places in the grid of the whole Moon, heights are bilinear between the samples. Safe for several threads.
/// </summary>
public sealed class ShiftedGrid : ChangedGrid
{
    private readonly int _down;
    private readonly int _right;
    private readonly double _below;
    private readonly double _beside;
    private readonly bool _isRing;

    private ShiftedGrid(ITerrainGrid grid, MapProjection projection, double down, double right)
        : base(grid)
    {
        Projection = projection;
        (_down, _right) = ((int)Math.Floor(down), (int)Math.Floor(right));
        (_below, _beside) = (down - _down, right - _right);
        GridWindow window = grid.Window;
        _isRing = projection is Equirectangular && window.Samples == grid.Samples;
        int first = window.FirstSample + _right + (_beside > 0.0 ? 1 : 0);
        int samples = window.Samples - (_beside > 0.0 ? 1 : 0);
        int turned = projection is Equirectangular ? ((first % grid.Samples) + grid.Samples) % grid.Samples : first;
        Window = new GridWindow(
            window.FirstLine + _down + (_below > 0.0 ? 1 : 0), window.EndLine + _down,
            _isRing ? 0 : turned, _isRing ? window.Samples : turned + samples);
        _right += turned - first;
    }

    /// <inheritdoc/>
    public override MapProjection Projection { get; }

    /// <inheritdoc/>
    public override GridWindow Window { get; }

    /// <inheritdoc/>
    /// <remarks>For a polar map they are those of the source, at other places.</remarks>
    public override IReadOnlyList<ITerrainGrid> StoredLevels =>
        Projection is PolarStereographic ? [.. Source.StoredLevels.Select(level => new ShiftedGrid(level, HalvedTo(level), 0.0, 0.0))] : [];

    private bool IsBetween => _below > 0.0 || _beside > 0.0;

    /// <summary>The map at another place.</summary>
    /// <param name="east">m towards the east, in its middle; of a map of latitude and longitude along the parallel there.</param>
    /// <param name="north">m towards the north.</param>
    /// <exception cref="BadInputException">Its middle is a pole, or it would not lie on its grid.</exception>
    public static ITerrainGrid Of(ITerrainGrid grid, double east, double north)
    {
        GridWindow window = grid.Window;
        (double line, double sample) = (0.5 * (window.FirstLine + window.EndLine - 1), 0.5 * (window.FirstSample + window.EndSample - 1));
        Vector3D middle = grid.Projection.DirectionOf(line, sample);
        Vector3D eastward = Vector3D.Cross(Vector3D.UnitZ, middle);
        if (eastward.Length * grid.ReferenceRadius < grid.Projection.Resolution.MetresPerPixel)
        {
            throw new BadInputException(
                $"{grid.ProductId}: the middle of the map is a pole, where no way is east, so it can't be shifted. Leave shift= out.");
        }

        if (grid.Projection is PolarStereographic polar)
        {
            eastward = eastward.Normalized();
            (double toLine, double toSample) = polar.PixelOf(
                middle + ((1.0 / grid.ReferenceRadius) * ((east * eastward) + (north * Vector3D.Cross(middle, eastward)))));
            PolarStereographic placed = polar with
            {
                LineOffset = polar.LineOffset - (toLine - line),
                SampleOffset = polar.SampleOffset - (toSample - sample),
            };
            return placed.Holds(grid.Lines, grid.Samples) ? new ShiftedGrid(grid, placed, 0.0, 0.0) : throw TooFar(grid);
        }

        double pixel = 2.0 * Math.PI * grid.ReferenceRadius / grid.Samples;
        (double down, double right) = (-north / pixel, east / (pixel * eastward.Length));
        ShiftedGrid shifted = new(grid, grid.Projection, Rounded(down), Rounded(right));
        return shifted.Window.FirstLine >= 0 && shifted.Window.EndLine <= grid.Lines && shifted.Window is { Lines: > 1, Samples: > 1 }
            ? shifted
            : throw TooFar(grid);

        // A millionth of a sample is far less than heights can tell; so a shift by whole samples is one.
        static double Rounded(double samples) => Math.Round(samples * 1e6) / 1e6;
    }

    /// <inheritdoc/>
    public override void ReadGaps(int line, int firstSample, Span<bool> isGap)
    {
        int first = SourceSample(firstSample);
        if (!IsBetween)
        {
            Source.ReadGaps(line - _down, first, isGap);
            return;
        }

        isGap.Clear();
        Span<bool> corner = new bool[isGap.Length];
        for (int i = 0; i < 4; i++)
        {
            if (WeightOf(i) > 0.0)
            {
                ReadCorner(i, line, firstSample, corner, Source.ReadGaps);
                for (int at = 0; at < isGap.Length; at++)
                {
                    isGap[at] |= corner[at];
                }
            }
        }
    }

    /// <inheritdoc/>
    public override bool MayHaveGapsIn(int firstLine, int lines, int firstSample, int samples) => IsBetween || _isRing
        ? MayHaveGaps
        : Source.MayHaveGapsIn(firstLine - _down, lines, SourceSample(firstSample), samples);

    /// <inheritdoc/>
    public override KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples) => IsBetween || _isRing
        ? null
        : Source.BoundsOf(firstLine - _down, lines, SourceSample(firstSample), samples);

    /// <inheritdoc/>
    public override void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        if (!IsBetween)
        {
            Source.ReadRadii(line - _down, SourceSample(firstSample), radii);
            return;
        }

        radii.Clear();
        Span<double> corner = new double[radii.Length];
        for (int i = 0; i < 4; i++)
        {
            if (WeightOf(i) is > 0.0 and var weight)
            {
                ReadCorner(i, line, firstSample, corner, Source.ReadRadii);
                for (int at = 0; at < radii.Length; at++)
                {
                    radii[at] += weight * corner[at];
                }
            }
        }
    }

    /// <inheritdoc/>
    public override void Prefetch(int firstLine, int lines, int firstSample, int samples)
    {
        if (!IsBetween)
        {
            Source.Prefetch(firstLine - _down, lines, SourceSample(firstSample), samples);
        }
    }

    private static BadInputException TooFar(ITerrainGrid grid) =>
        new($"{grid.ProductId}: shifted so far it would lie beyond the map's projection. Give a smaller shift=.");

    private MapProjection HalvedTo(ITerrainGrid level)
    {
        MapProjection projection = Projection;
        for (int i = Projection.Resolution.HalvingsTo(level.Projection.Resolution); i > 0; i--)
        {
            projection = projection.Halved()!;
        }

        return projection;
    }

    /// <summary>Weight of one of the four samples around: bit 0 is the one to the left, bit 1 the one above.</summary>
    private double WeightOf(int corner) =>
        ((corner & 1) == 0 ? 1.0 - _beside : _beside) * ((corner & 2) == 0 ? 1.0 - _below : _below);

    private int SourceSample(int sample)
    {
        int source = sample - _right;
        return _isRing ? ((source % Samples) + Samples) % Samples : source;
    }

    /// <summary>Reads one of the four samples around each; of a ring in pieces that end with its last one.</summary>
    private void ReadCorner<T>(int corner, int line, int firstSample, Span<T> values, ReadPart<T> read)
    {
        int row = line - _down - (corner >> 1);
        for (int done = 0; done < values.Length;)
        {
            int first = SourceSample(firstSample + done - (corner & 1));
            int count = _isRing ? Math.Min(values.Length - done, Samples - first) : values.Length;
            read(row, first, values.Slice(done, count));
            done += count;
        }
    }

    private delegate void ReadPart<T>(int line, int firstSample, Span<T> values);
}
