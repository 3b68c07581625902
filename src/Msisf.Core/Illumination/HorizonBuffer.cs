using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>
/// The horizon of one place while it is looked for: the tangent of its elevation in columns of azimuth, column 0 in the north, further ones
/// over east. A bound of each group of columns tells quickly that something can't rise above them. Not safe for several threads.
/// </summary>
internal sealed class HorizonBuffer
{
    /// <summary>Columns of a group.</summary>
    public const int Group = 32;

    /// <summary>By how much of its tangent the great circle of an edge of one group bulges, at most: 4.7e-6 in 1024 groups.</summary>
    public const float NarrowBulge = 1e-5f;

    /// <summary>Columns that are raised at once; so many more are there, so that nobody has to ask for the end.</summary>
    private const int Lanes = 16;

    /// <summary>Columns: above the rounding of a column in float.</summary>
    private const float ColumnRounding = 0.01f;

    private readonly float[] _tangents;
    private readonly float[] _least;
    private readonly float[] _sines;
    private readonly float[] _cosines;
    private readonly int[] _owners;
    private float[] _tops;

    /// <summary>Makes a buffer.</summary>
    /// <param name="columns">Columns of a turn, a power of two from 1024 on.</param>
    public HorizonBuffer(int columns)
    {
        Columns = columns;
        (_tangents, _least) = (new float[columns + Lanes], new float[columns / Group]);
        (_sines, _cosines) = (new float[columns], new float[columns]);
        _tops = new float[columns / Group];
        _owners = new int[columns + Lanes];
        Array.Fill(_owners, -1);
        Array.Fill(_tops, float.PositiveInfinity);
        for (int column = 0; column < columns; column++)
        {
            (double sine, double cosine) = Math.SinCos(2.0 * Math.PI * column / columns);
            (_sines[column], _cosines[column]) = ((float)sine, (float)cosine);
        }
    }

    /// <summary>Columns of a turn.</summary>
    public int Columns { get; }

    /// <summary>Number of what is raised to next.</summary>
    public int Owner { get; set; }

    /// <summary>For each column the <see cref="Owner"/> that raised it last; -1 for none.</summary>
    public ReadOnlySpan<int> Owners => _owners.AsSpan(0, Columns);

    /// <summary>Tangents of the elevation at the columns.</summary>
    public ReadOnlySpan<float> Tangents => _tangents.AsSpan(0, Columns);

    /// <summary>Begins a place.</summary>
    /// <param name="bottom">Tangent of an elevation below which nothing needs to be known.</param>
    /// <param name="tops">For each group of columns the tangent of one above which nothing needs to be known.</param>
    public void Clear(float bottom, float[] tops)
    {
        _tops = tops;
        Array.Fill(_tangents, bottom);
        Array.Fill(_owners, -1);
        for (int group = 0; group < _least.Length; group++)
        {
            _least[group] = bottom >= tops[group] ? float.PositiveInfinity : bottom;
        }
    }

    /// <summary>Lower bound of the tangents from one column to another, where more needs to be known; infinite if nothing does.</summary>
    /// <param name="first">From 0 to below <see cref="Columns"/>.</param>
    /// <param name="count">1 to <see cref="Columns"/>; the columns after the last one are the first ones.</param>
    public float LeastFrom(int first, int count)
    {
        int groups = _least.Length;
        int from = first / Group;
        int left = Math.Min(groups, ((first + count - 1) / Group) - from + 1);
        float least = float.PositiveInfinity;
        while (left > 0)
        {
            int run = Math.Min(left, groups - from);
            int group = from;
            if (run >= 16)
            {
                Vector512<float> lanes = ArrayLanes.Load(_least, group);
                for (group += 16; group + 16 <= from + run; group += 16)
                {
                    lanes = Vector512.MinNative(lanes, ArrayLanes.Load(_least, group));
                }

                least = Math.Min(least, LaneMasks.Min(lanes));
            }

            for (; group < from + run; group++)
            {
                least = _least[group] < least ? _least[group] : least;
            }

            (left, from) = (left - run, 0);
        }

        return least;
    }

    /// <summary>Raises the horizon to an edge of the terrain, if it is a narrow one that does not cross the north.</summary>
    /// <param name="column">Azimuth of one end, in columns.</param>
    /// <param name="tangent">Tangent of its elevation.</param>
    /// <param name="otherColumn">Azimuth of the other.</param>
    /// <param name="otherTangent">Tangent of its elevation.</param>
    /// <returns>Whether that is done.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryRaise(float column, float tangent, float otherColumn, float otherTangent)
    {
        float width = otherColumn - column;
        if (width < 0.0f)
        {
            (column, tangent, otherTangent, width) = (otherColumn, otherTangent, tangent, -width);
        }

        int first = (int)MathF.Ceiling(column - ColumnRounding);
        int last = (int)MathF.Floor(column + width + ColumnRounding);
        if (last < first)
        {
            return true;
        }

        if (width > Group || first < 0 || last >= Columns)
        {
            return false;
        }

        (int group, int lastGroup) = (first / Group, last / Group);
        float top = Math.Max(tangent, otherTangent);
        if (top + (NarrowBulge * Math.Abs(top)) > Math.Min(_least[group], _least[lastGroup]))
        {
            float slope = width > ColumnRounding ? (otherTangent - tangent) / width : 0.0f;
            float from = width > ColumnRounding ? tangent + (slope * (first - column)) : top;
            RaiseNarrow(first, last - first + 1, from, slope, top);
        }

        return true;
    }

    private void RaiseNarrow(int first, int count, float value, float slope, float top)
    {
        Vector512<float> most = Vector512.Create(top);
        Vector512<float> line = Vector512.Create(value) + (Vector512.Create(slope) * Vector512<float>.Indices);
        Vector512<int> lanes = Vector512<int>.Indices;
        bool isRaised = false;
        for (int done = 0; done < count; done += Lanes)
        {
            Vector512<float> isThere = Vector512.LessThan(lanes, Vector512.Create(count - done)).AsSingle();
            isRaised |= Raise(
                first + done,
                Vector512.ConditionalSelect(isThere, Vector512.MinNative(line, most), Vector512.Create(float.NegativeInfinity)));
            line += Vector512.Create(Lanes * slope);
        }

        Renew(isRaised, first, count);
    }

    /// <summary>Raises the horizon to an edge of the terrain.</summary>
    /// <param name="a">One end.</param>
    /// <param name="b">The other.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Raise(in HorizonPoint a, in HorizonPoint b)
    {
        float span = b.Column - a.Column;
        span -= span > 0.5f * Columns ? Columns : span < -0.5f * Columns ? -Columns : 0;
        ref readonly HorizonPoint left = ref (span < 0 ? ref b : ref a);
        ref readonly HorizonPoint right = ref (span < 0 ? ref a : ref b);
        double width = Math.Abs(span);
        int first = (int)Math.Ceiling(left.Column - ColumnRounding);
        int count = (int)Math.Floor(left.Column + width + ColumnRounding) - first + 1;
        float top = Math.Max(left.Tangent, right.Tangent);
        int start = first & (Columns - 1);
        if (count <= 0 || HighestOf(top, width) <= LeastFrom(start, count))
        {
            return;
        }

        if (width <= Group)
        {
            float slope = width > ColumnRounding ? (float)((right.Tangent - left.Tangent) / width) : 0.0f;
            float atFirst = width > ColumnRounding ? left.Tangent + (slope * (first - left.Column)) : top;
            int here = Math.Min(count, Columns - start);
            RaiseNarrow(start, here, atFirst, slope, top);
            RaiseNarrow(0, count - here, atFirst + (slope * here), slope, top);
            return;
        }

        // The plane through the place and the edge: n . (sin, cos, tangent) = 0.
        double up = (left.East * right.North) - (left.North * right.East);
        if (up == 0.0)
        {
            return;
        }

        float alongSine = (float)(-((left.North * right.Up) - (left.Up * right.North)) / up);
        float alongCosine = (float)(-((left.Up * right.East) - (left.East * right.Up)) / up);

        // Beside its ends the plane of an edge that leads away from the place is steeper than any rounding allows for.
        RaiseTo(start, Math.Min(top, (alongSine * _sines[start]) + (alongCosine * _cosines[start])));
        int last = (start + count - 1) & (Columns - 1);
        RaiseTo(last, Math.Min(top, (alongSine * _sines[last]) + (alongCosine * _cosines[last])));
        int inner = Math.Max(0, count - 2);
        int from = (start + 1) & (Columns - 1);
        int until = Math.Min(inner, Columns - from);
        RaisePlane(from, until, alongSine, alongCosine);
        RaisePlane(0, inner - until, alongSine, alongCosine);
    }

    /// <summary>Upper bound of the tangent along an edge: a great circle bulges above its ends.</summary>
    /// <param name="top">The greater tangent of its ends.</param>
    /// <param name="width">Columns between them.</param>
    public float HighestOf(float top, double width)
    {
        double half = width * (Math.PI / Columns);
        return top <= 0.0f ? top : half > 1.0 ? float.PositiveInfinity : (float)(top / (1.0 - (0.5 * half * half)));
    }

    private void RaiseTo(int column, float tangent) => Renew(Raise(column, tangent), column, 1);

    private void RaisePlane(int first, int count, float alongSine, float alongCosine)
    {
        Vector512<float> bySine = Vector512.Create(alongSine);
        Vector512<float> byCosine = Vector512.Create(alongCosine);
        bool isRaised = false;
        int done = 0;
        for (; done + 16 <= count; done += 16)
        {
            int at = first + done;
            isRaised |= Raise(at, (bySine * ArrayLanes.Load(_sines, at)) + (byCosine * ArrayLanes.Load(_cosines, at)));
        }

        for (; done < count; done++)
        {
            int at = first + done;
            isRaised |= Raise(at, (alongSine * _sines[at]) + (alongCosine * _cosines[at]));
        }

        Renew(isRaised, first, count);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool Raise(int at, Vector512<float> line)
    {
        Vector512<float> before = ArrayLanes.Load(_tangents, at);
        Vector512<float> isHigher = Vector512.GreaterThan(line, before);
        if (isHigher.AsInt32() == Vector512<int>.Zero)
        {
            return false;
        }

        Vector512.MaxNative(before, line).StoreTo(_tangents, at);
        Vector512.ConditionalSelect(isHigher.AsInt32(), Vector512.Create(Owner), ArrayLanes.Load(_owners, at)).StoreTo(_owners, at);
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool Raise(int at, float tangent)
    {
        if (!(tangent > _tangents[at]))
        {
            return false;
        }

        (_tangents[at], _owners[at]) = (tangent, Owner);
        return true;
    }

    /// <summary>Computes the bounds of groups again.</summary>
    private void Renew(bool isRaised, int first, int count)
    {
        if (!isRaised)
        {
            return;
        }

        for (int group = first / Group; group <= (first + count - 1) / Group; group++)
        {
            int at = group * Group;
            float least = LaneMasks.Min(
                Vector512.MinNative(ArrayLanes.Load(_tangents, at), ArrayLanes.Load(_tangents, at + Lanes)));
            _least[group] = least >= _tops[group] ? float.PositiveInfinity : least;
        }
    }
}
