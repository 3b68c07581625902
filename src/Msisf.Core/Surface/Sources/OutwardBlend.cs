using System.Collections.Concurrent;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// A model, or a level of it, whose ground meets the finer models in it: its own heights and those of an <see cref="OutlineField"/>. Its
/// samples without data lie on the coarser models. Safe for several threads.
/// </summary>
internal class OutwardBlend : ChangedGrid
{
    private const int Side = DataGaps.Side;

    private const int Unknown = 0;
    private const int Untouched = 1;
    private const int Changed = 2;

    private readonly OutlineField? _field;
    private readonly CoarserGround? _coarser;
    private readonly int _columns;
    private readonly int[] _states;
    private readonly ConcurrentDictionary<int, double[]> _tiles = new();

    /// <summary>Takes a model; nothing of it is read yet.</summary>
    /// <param name="grid">The model, or a level of it.</param>
    /// <param name="field">What it gets; null for nothing.</param>
    /// <param name="coarser">The coarser models; null of the coarsest.</param>
    protected OutwardBlend(ITerrainGrid grid, OutlineField? field, CoarserGround? coarser)
        : base(grid)
    {
        (_field, _coarser) = (field, grid.MayHaveGaps ? coarser : null);
        _columns = (grid.Window.Samples + Side - 1) / Side;
        _states = new int[_columns * ((grid.Window.Lines + Side - 1) / Side)];
        (double min, double max) = grid.RadiusLimits;
        RadiusLimits = (min + (field?.Limits.Min ?? 0.0), max + (field?.Limits.Max ?? 0.0));
        if (_coarser is not null)
        {
            (min, max) = _coarser.RadiusLimits;
            RadiusLimits = (Math.Min(min, RadiusLimits.Min), Math.Max(max, RadiusLimits.Max));
        }
    }

    /// <inheritdoc/>
    public override (double Min, double Max) RadiusLimits { get; }

    /// <summary>The model with what it gets; itself if that is nothing.</summary>
    /// <param name="grid">The model, or a level of it.</param>
    /// <param name="field">What it gets; null for nothing.</param>
    /// <param name="coarser">The coarser models; null of the coarsest.</param>
    public static ITerrainGrid Of(ITerrainGrid grid, OutlineField? field, CoarserGround? coarser) =>
        field is null && (coarser is null || !grid.MayHaveGaps) ? grid
        : grid is IGlobalGrid moon ? new OutwardMoon(moon, field)
        : new OutwardBlend(grid, field, coarser);

    /// <inheritdoc/>
    public override KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples) =>
        _field is null && !Source.MayHaveGapsIn(firstLine, lines, firstSample, samples)
            ? Source.BoundsOf(firstLine, lines, firstSample, samples)
            : null;

    /// <inheritdoc/>
    public override void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        if (_coarser is null)
        {
            Source.ReadRadii(line, firstSample, radii);
        }
        else
        {
            ReadWithGaps(line, firstSample, radii);
        }

        int down = line - Window.FirstLine;
        for (int done = 0; done < radii.Length && _field is not null;)
        {
            int right = RightOf(firstSample + done);
            int tile = (down / Side * _columns) + (right / Side);
            int count = Math.Min(radii.Length - done, Math.Min(Side - (right % Side), Window.Samples - right));
            if (StateOf(tile) == Changed)
            {
                ReadOnlySpan<double> heights = _tiles.GetOrAdd(tile, NewTile).AsSpan((down % Side * Side) + (right % Side), count);
                for (int i = 0; i < count; i++)
                {
                    radii[done + i] += heights[i];
                }
            }

            done += count;
        }
    }

    /// <inheritdoc/>
    public override bool IsBlended(int line, int sample)
    {
        (int down, int right) = (line - Window.FirstLine, RightOf(sample));
        int tile = (down / Side * _columns) + (right / Side);
        return _field is not null && StateOf(tile) == Changed
            && _tiles.GetOrAdd(tile, NewTile)[(down % Side * Side) + (right % Side)] != 0.0;
    }

    private int RightOf(int sample)
    {
        int right = sample - Window.FirstSample;
        return Projection is Equirectangular ? (right + Samples) % Samples : right; // over the prime meridian
    }

    private void ReadWithGaps(int line, int firstSample, Span<double> radii)
    {
        Span<bool> isGap = radii.Length <= Side ? stackalloc bool[radii.Length] : new bool[radii.Length];
        Source.ReadGaps(line, firstSample, isGap);
        for (int start = 0; start < radii.Length;)
        {
            int length = isGap[start..].IndexOf(!isGap[start]);
            length = length < 0 ? radii.Length - start : length;
            if (!isGap[start])
            {
                Source.ReadRadii(line, firstSample + start, radii.Slice(start, length));
            }
            else
            {
                for (int i = start; i < start + length; i++)
                {
                    radii[i] = _coarser!.RadiusAt(Projection.DirectionOf(line, firstSample + i));
                }
            }

            start += length;
        }
    }

    /// <summary>Whether a tile may get any height; threads find the same.</summary>
    private int StateOf(int tile)
    {
        int state = Volatile.Read(ref _states[tile]);
        if (state == Unknown)
        {
            (Vector3D middle, double around) = BallOf(tile);
            state = _field!.DistanceOf(middle, around) is null ? Untouched : Changed;
            Volatile.Write(ref _states[tile], state);
        }

        return state;
    }

    /// <summary>Direction of a tile's middle, and m: no sample of it is farther away.</summary>
    private (Vector3D Middle, double Around) BallOf(int tile)
    {
        const double Margin = 1.1;
        (double line, double sample) = FirstOf(tile);
        Vector3D middle = Projection.DirectionOf(line + (0.5 * Side), sample + (0.5 * Side));
        double around = 0.0;
        for (int i = 0; i < 9; i++)
        {
            // Corners, and middles of the sides, which may be farther away beside a pole.
            Vector3D rim = Projection.DirectionOf(line + (0.5 * Side * (i / 3)), sample + (0.5 * Side * (i % 3)));
            around = Math.Max(around, (rim - middle).Length);
        }

        return (middle, Margin * around * MoonConstants.ReferenceRadius);
    }

    private (int Line, int Sample) FirstOf(int tile) =>
        (Window.FirstLine + (tile / _columns * Side), Window.FirstSample + (tile % _columns * Side));

    /// <summary>
    /// m: what the samples of a tile get; nothing where they have no data. Far from outlines it is found for some of them, and bilinear
    /// between these.
    /// </summary>
    private double[] NewTile(int tile)
    {
        double[] heights = new double[Side * Side];
        (int line, int sample) = FirstOf(tile);
        (Vector3D middle, double around) = BallOf(tile);
        double distance = _field!.DistanceOf(middle, around) ?? _field.Reach;
        int step = StepAt(distance - around);
        int nodes = (Side / step) + (step > 1 ? 1 : 0);
        double[] found = new double[nodes * nodes];
        for (int node = 0; node < found.Length; node++)
        {
            found[node] = _field.At(
                Projection.DirectionOf(line + (node / nodes * step), sample + (node % nodes * step)), distance + around);
        }

        if (step == 1)
        {
            heights = found;
        }
        else
        {
            Interpolate(found, nodes, step, heights);
        }

        RemoveGaps(line, sample, heights);
        return heights;
    }

    private static void Interpolate(double[] found, int nodes, int step, double[] heights)
    {
        for (int i = 0; i < heights.Length; i++)
        {
            (int down, int right) = (i / Side, i % Side);
            int node = (down / step * nodes) + (right / step);
            (double v, double u) = (down % step / (double)step, right % step / (double)step);
            heights[i] = ((1.0 - v) * (((1.0 - u) * found[node]) + (u * found[node + 1])))
                + (v * (((1.0 - u) * found[node + nodes]) + (u * found[node + nodes + 1])));
        }
    }

    /// <summary>
    /// Samples from one that is found to the next, a divisor of <see cref="Side"/>: between them the heights are bilinear up to a
    /// thousandth, as they change over a distance like that from the outline.
    /// </summary>
    private int StepAt(double distance)
    {
        const double StepsOfDistance = 32.0;
        double samples = distance / (StepsOfDistance * Projection.Resolution.MetresPerPixel);
        int step = 1;
        while (step < Side && 2.0 * step <= samples)
        {
            step *= 2;
        }

        return step;
    }

    private void RemoveGaps(int line, int sample, double[] heights)
    {
        int samples = Math.Min(Side, Window.EndSample - sample);
        Span<bool> gaps = stackalloc bool[samples];
        for (int row = 0; row < Side && line + row < Window.EndLine && _coarser is not null; row++)
        {
            Source.ReadGaps(line + row, sample, gaps);
            for (int column = 0; column < samples; column++)
            {
                heights[(row * Side) + column] = gaps[column] ? 0.0 : heights[(row * Side) + column];
            }
        }
    }

    /// <summary>The same of a model of the whole Moon.</summary>
    private sealed class OutwardMoon(IGlobalGrid grid, OutlineField? field) : OutwardBlend(grid, field, coarser: null), IGlobalGrid
    {
        /// <inheritdoc/>
        public int PixelsPerDegree { get; } = grid.PixelsPerDegree;
    }
}
