using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>
/// Stores horizons in little room: corners between which the tangent of the elevation is straight, 4 bytes each. Immutable.
/// </summary>
/// <param name="Columns">Columns of a turn; at most 65,536.</param>
/// <param name="BottomDegrees">degrees: elevations below it are stored as it.</param>
/// <param name="TopDegrees">degrees: elevations above it are stored as it.</param>
internal sealed record HorizonProfile(int Columns, double BottomDegrees, double TopDegrees)
{
    private readonly float[] _inverse = [.. Enumerable.Range(0, Columns + 1).Select(count => count == 0 ? 0.0f : 1.0f / count)];
    private readonly float[] _tangents = [.. Enumerable.Range(0, ushort.MaxValue + 1).Select(
        level => (float)Math.Tan(double.DegreesToRadians(BottomDegrees + (level * (TopDegrees - BottomDegrees) / ushort.MaxValue))))];

    /// <summary>The corners of a place without a horizon.</summary>
    public static uint[] Empty(int columns) => [0, ((uint)columns - 1) << 16];

    /// <summary>Elements of a table that <see cref="Read"/> fills.</summary>
    public static int TableLength(int columns) => columns + Vector512<float>.Count;

    /// <summary>degrees: the step of stored elevations.</summary>
    public double StepDegrees => (TopDegrees - BottomDegrees) / ushort.MaxValue;

    /// <summary>Finds the corners of a horizon.</summary>
    /// <param name="tangents">Tangent of the elevation at each column.</param>
    /// <param name="toleranceDegrees">degrees: how far the straight lines may be off at a column, but for the step.</param>
    /// <param name="corners">Receives the corners, column in the upper 16 bits; the first is at column 0.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Store(ReadOnlySpan<float> tangents, double toleranceDegrees, List<uint> corners)
    {
        float bottom = TangentOf(0);
        float top = TangentOf(ushort.MaxValue);
        float tolerance = (float)double.DegreesToRadians(toleranceDegrees);
        int start = 0;
        ushort stored = LevelOf(Math.Clamp(tangents[0], bottom, top));
        corners.Add(stored);
        float from = TangentOf(stored);
        (float least, float most) = (float.NegativeInfinity, float.PositiveInfinity);
        for (int column = 1; column <= Columns; column++)
        {
            float tangent = Math.Clamp(tangents[column == Columns ? 0 : column], bottom, top);
            float allowed = tolerance * (1.0f + (tangent * tangent));
            float inverse = _inverse[column - start];
            float above = (tangent + allowed - from) * inverse;
            float below = (tangent - allowed - from) * inverse;
            if (below > most || above < least)
            {
                // The line through the corner before that is in the middle of what is allowed ends one column earlier.
                int end = column - 1;
                float slope = float.IsFinite(least) ? 0.5f * (least + most) : 0.0f;
                stored = LevelOf(Math.Clamp(from + (slope * (end - start)), bottom, top));
                corners.Add(((uint)end << 16) | stored);
                (start, from) = (end, TangentOf(stored));
                (above, below) = (tangent + allowed - from, tangent - allowed - from);
                (least, most) = (below, above);
            }
            else
            {
                (least, most) = (Math.Max(least, below), Math.Min(most, above));
            }
        }

        // The last line, to the column after the last one, which is the first.
        uint last = LevelOf(Math.Clamp(from + (0.5f * (least + most) * (Columns - start)), bottom, top));
        corners.Add((((uint)Columns - 1) << 16) | last);
    }

    /// <summary>Fills a table with a stored horizon.</summary>
    /// <param name="corners">As <see cref="Store"/> gave them.</param>
    /// <param name="tangents">
    /// Receives the tangent at each column, after them that of the first again, and then what means nothing: <see cref="TableLength"/>.
    /// </param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Read(ReadOnlySpan<uint> corners, Span<float> tangents)
    {
        float from = TangentOf((ushort)corners[0]);
        int start = 0;
        for (int corner = 1; corner < corners.Length; corner++)
        {
            int end = corner == corners.Length - 1 ? Columns : (int)(corners[corner] >> 16);
            float to = TangentOf((ushort)corners[corner]);
            float slope = (to - from) * _inverse[end - start];
            Vector512<float> indices = Vector512.ConvertToSingle(Vector512<int>.Indices);
            for (int column = start; column < end; column += Vector512<float>.Count)
            {
                // What is written beyond the end is written again by the next line.
                (Vector512.Create(from) + (Vector512.Create(slope) * indices)).CopyTo(tangents[column..]);
                indices += Vector512.Create((float)Vector512<float>.Count);
            }

            (start, from) = (end, to);
        }

        tangents[Columns] = tangents[0];
    }

    private ushort LevelOf(float tangent) =>
        (ushort)Math.Round((double.RadiansToDegrees(Math.Atan(tangent)) - BottomDegrees) / StepDegrees);

    private float TangentOf(ushort level) => _tangents[level];
}
