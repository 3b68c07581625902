using System.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Lowest height of the terrain in each plane and column of a <see cref="SectionGrid"/>, from the section of each facet with each plane.
/// Each thread needs its own object.
/// </summary>
internal sealed class TerrainSections
{
    /// <summary>m: more than rounding moves a section, within the limits of the next two numbers.</summary>
    private const double Margin = 1e-2;

    /// <summary>Change of u with v above which a section counts with its lowest point everywhere.</summary>
    private const double MaxSteepness = 1e4;

    /// <summary>m: if an edge that a plane cuts lies less across the plane, the whole facet counts with its lowest corner.</summary>
    private const double MinDepthRange = 1.0;

    private readonly BlockVertices _vertices = new();
    private readonly int[] _planes = new int[(CellBlock.Size + 1) * BlockVertices.Stride];
    private SectionGrid _grid = null!;

    /// <summary>
    /// Lowest height, m, plane by plane, rounded down; plus infinity where no terrain has been added, minus infinity where it is unknown.
    /// </summary>
    public float[] Lowest { get; private set; } = [];

    /// <summary>Begins with no terrain.</summary>
    public void Start(SectionGrid grid)
    {
        _grid = grid;
        if (Lowest.Length < grid.Planes * grid.Columns)
        {
            Lowest = new float[grid.Planes * grid.Columns];
        }

        Array.Fill(Lowest, float.PositiveInfinity, 0, grid.Planes * grid.Columns);
    }

    /// <summary>Adds the facets of a block.</summary>
    public void Add(SurfaceModel surface, CellBlock block, LightFrame frame)
    {
        _vertices.Load(surface, block, default);
        int length = _vertices.Lines * BlockVertices.Stride;
        frame.FromBodyFixed(_vertices.X.AsSpan(0, length), _vertices.Y.AsSpan(0, length), _vertices.Z.AsSpan(0, length));
        for (int i = 0; i < length; i++)
        {
            _planes[i] = _grid.PlaneAt(_vertices.Z[i]);
        }

        for (int line = 0; line + 1 < _vertices.Lines; line++)
        {
            uint inBlock = uint.MaxValue >> (CellBlock.Size + 1 - _vertices.Samples);
            for (uint cells = _vertices.CellsOfLine(line) & inBlock; cells != 0; cells &= cells - 1)
            {
                int northWest = (line * BlockVertices.Stride) + BitOperations.TrailingZeroCount(cells);
                int southWest = northWest + BlockVertices.Stride;
                AddFacet(northWest, southWest, southWest + 1);
                if (!_vertices.IsOfSeams)
                {
                    AddFacet(northWest, southWest + 1, northWest + 1);
                }
            }
        }
    }

    /// <summary>Adds terrain of which only bounds are known.</summary>
    public void AddUnknown(in LightBounds bounds)
    {
        int first = _grid.ColumnOf(bounds.Box.MinV);
        int count = _grid.ColumnOf(bounds.Box.MaxV) - first + 1;
        int last = _grid.PlaneAt(bounds.MaxDepth);
        for (int plane = Math.Max(_grid.PlaneAt(bounds.MinDepth), 0); plane <= last; plane++)
        {
            Lowest.AsSpan((plane * _grid.Columns) + first, count).Fill(float.NegativeInfinity);
        }
    }

    /// <summary>Adds what another object has found.</summary>
    public void Add(TerrainSections other)
    {
        for (int i = 0; i < _grid.Planes * _grid.Columns; i++)
        {
            Lowest[i] = Math.Min(Lowest[i], other.Lowest[i]);
        }
    }

    private void AddFacet(int a, int b, int c)
    {
        int last = Math.Max(_planes[a], Math.Max(_planes[b], _planes[c]));
        for (int plane = Math.Min(_planes[a], Math.Min(_planes[b], _planes[c])) + 1; plane <= last; plane++)
        {
            bool isABehind = _planes[a] >= plane;
            bool isBBehind = _planes[b] >= plane;
            bool isCBehind = _planes[c] >= plane;
            (int alone, int left, int right) = isABehind == isBBehind ? (c, a, b) : isABehind == isCBehind ? (b, c, a) : (a, b, c);
            if (Math.Min(DepthRange(alone, left), DepthRange(alone, right)) < MinDepthRange)
            {
                AddWhole(plane, a, b, c);
                continue;
            }

            (double leftU, double leftV) = Cut(alone, left, plane);
            (double rightU, double rightV) = Cut(alone, right, plane);
            if (leftV <= rightV)
            {
                AddSection(plane, leftU, leftV, rightU, rightV);
            }
            else
            {
                AddSection(plane, rightU, rightV, leftU, leftV);
            }
        }
    }

    private double DepthRange(int from, int to) => Math.Abs(_vertices.Z[from] - _vertices.Z[to]);

    /// <summary>The point of an edge in a plane.</summary>
    private (double U, double V) Cut(int from, int to, int plane)
    {
        double part = (_grid.DepthOf(plane) - _vertices.Z[from]) / (_vertices.Z[to] - _vertices.Z[from]);
        double u = _vertices.X[from];
        double v = _vertices.Y[from];
        return (u + (part * (_vertices.X[to] - u)), v + (part * (_vertices.Y[to] - v)));
    }

    private void AddWhole(int plane, int a, int b, int c)
    {
        (double[] us, double[] vs) = (_vertices.X, _vertices.Y);
        double minV = Math.Min(vs[a], Math.Min(vs[b], vs[c]));
        double maxV = Math.Max(vs[a], Math.Max(vs[b], vs[c]));
        if (maxV >= _grid.MinV && minV <= _grid.MaxV && Math.Max(us[a], Math.Max(us[b], us[c])) >= 0.0)
        {
            Lower(plane, _grid.ColumnOf(minV), _grid.ColumnOf(maxV), Math.Min(us[a], Math.Min(us[b], us[c])));
        }
    }

    private void AddSection(int plane, double startU, double startV, double endU, double endV)
    {
        if (endV < _grid.MinV || startV > _grid.MaxV || Math.Max(startU, endU) < 0.0)
        {
            return;
        }

        int first = _grid.ColumnOf(startV);
        int last = _grid.ColumnOf(endV);
        double lowestU = Math.Min(startU, endU);
        double perV = (endU - startU) / (endV - startV);
        if (first == last || !(Math.Abs(perV) <= MaxSteepness))
        {
            Lower(plane, first, last, lowestU);
            return;
        }

        for (int column = first; column <= last; column++)
        {
            double v = perV < 0.0
                ? column == last ? endV : _grid.StartOf(column + 1)
                : column == first ? startV : _grid.StartOf(column);
            Lower(plane, column, column, Math.Max(lowestU, startU + ((Math.Clamp(v, startV, endV) - startV) * perV)));
        }
    }

    private void Lower(int plane, int first, int last, double u)
    {
        float height = MathF.BitDecrement((float)(u - _grid.BaseU - Margin));
        Span<float> heights = Lowest.AsSpan((plane * _grid.Columns) + first, last - first + 1);
        for (int i = 0; i < heights.Length; i++)
        {
            heights[i] = Math.Min(heights[i], height);
        }
    }
}
