using System.Runtime.Intrinsics;

namespace Msisf.Core.Detector.Psf;

/// <summary>The image of a point anywhere in a pixel: how much of its light each pixel around it gets. Immutable.</summary>
/// <remarks>
/// What a pixel gets is a smooth function of its place relative to the point, the point spread function integrated over the pixel. It is
/// tabulated, several nodes a pixel, and interpolated between them. The nodes that a point needs lie in the same place in all its pixels,
/// and each such set of nodes gets the whole light, so that no light is lost or made by the interpolation.
/// </remarks>
public sealed class PointImage
{
    /// <summary>Nodes a pixel of a formula: at least this many; odd, so that borders of pixels are borders of cells.</summary>
    private const int LeastNodes = 9;

    private const int MostNodes = 33;

    /// <summary>Nodes over the length on which a formula changes.</summary>
    private const double NodesOfScale = 4.0;

    /// <summary>Nodes along an axis between which a formula is interpolated; of a file's kernel two, with which it is exact.</summary>
    private const int NodesOfFormula = 6;

    private readonly Part[] _parts;

    /// <summary>Makes the table of a point spread function.</summary>
    /// <param name="kernel">Null for one that leaves the light within the point's pixel.</param>
    public PointImage(PointSpreadKernel? kernel)
    {
        _parts = kernel is null ? [] : [.. kernel.Parts.Select(part => new Part(part))];
        Radius = _parts.Length == 0 ? 0 : _parts.Max(part => part.Radius);
    }

    /// <summary>px: pixels farther than this from the point's own, along rows or columns, get nothing.</summary>
    public int Radius { get; }

    /// <summary>Whether the image of a point is its pixel.</summary>
    public bool IsPoint => _parts.Length == 0;

    /// <summary>px: length over which the image changes; infinite for a point that stays in its pixel.</summary>
    public double Scale => _parts.Length == 0 ? double.PositiveInfinity : _parts.Min(part => part.Scale);

    /// <summary>Adds the light of a point to an image. What falls outside is lost.</summary>
    /// <param name="pixels">By rows from the top.</param>
    /// <param name="width">px.</param>
    /// <param name="rows">The rows that get light, from 0.</param>
    /// <param name="x">Rendering coordinate of the point.</param>
    /// <param name="y">Rendering coordinate of the point.</param>
    /// <param name="light">How much light it has.</param>
    /// <returns>How much of it falls on these rows.</returns>
    public double Add(Span<double> pixels, int width, (int First, int End) rows, double x, double y, double light)
    {
        int column = (int)Math.Floor(x + 0.5) - 1; // from 0
        int row = (int)Math.Floor(y + 0.5) - 1;
        if (_parts.Length == 0)
        {
            if (column < 0 || column >= width || row < rows.First || row >= rows.End)
            {
                return 0.0;
            }

            pixels[(row * width) + column] += light;
            return light;
        }

        double added = 0.0;
        foreach (Part part in _parts)
        {
            added += part.Add(pixels, width, rows, (column, row), (x - 1.0 - column, y - 1.0 - row), light);
        }

        return added;
    }

    /// <summary>One function of several that share the light.</summary>
    private sealed class Part
    {
        private readonly double[] _table; // [row, column modulo nodes, column over nodes]: the pixel's centre, in nodes from the point
        private readonly int _stride; // from one column modulo nodes to the next: the same node of neighbouring pixels lie side by side
        private readonly int _nodes; // a pixel
        private readonly int _reach; // nodes from the middle of the table to its border
        private readonly int _order; // nodes along an axis that are interpolated

        public Part(SpreadPart part)
        {
            _nodes = part.Formula is { } formula
                ? Math.Clamp(((int)Math.Ceiling(NodesOfScale / formula.Scale) | 1), LeastNodes, MostNodes)
                : 1;
            _order = part.Formula is null ? 2 : NodesOfFormula;
            Scale = part.Formula?.Scale ?? 1.0;
            double[] cells = part.Formula is { } spread
                ? PixelIntegrals.Of(spread, part.Cutoff, 1.0 / _nodes)
                : part.Weights;
            int cellReach = ((int)Math.Round(Math.Sqrt(cells.Length)) - 1) / 2;
            Radius = ((cellReach + (_nodes / 2) + _order) / _nodes) + 1;
            _reach = (Radius + 1) * _nodes;
            _stride = (((2 * _reach) + 1) / _nodes) + 1;
            _table = SideBySide(Sums(cells, cellReach, part.Fraction / cells.Sum()));
        }

        public int Radius { get; }

        public double Scale { get; }

        public double Add(
            Span<double> pixels, int width, (int First, int End) rows, (int Column, int Row) middle, (double X, double Y) offset,
            double light)
        {
            double added = 0.0;
            Span<double> across = stackalloc double[_order];
            Span<double> down = stackalloc double[_order];
            int firstX = Weights(offset.X, across);
            int firstY = Weights(offset.Y, down);
            Span<int> places = stackalloc int[_order]; // of the nodes of the pixel 'left' in a row of the table
            int top = Math.Max(rows.First, middle.Row - Radius);
            int bottom = Math.Min(rows.End - 1, middle.Row + Radius);
            int left = Math.Max(0, middle.Column - Radius);
            int right = Math.Min(width - 1, middle.Column + Radius);
            for (int i = 0; i < _order; i++)
            {
                int node = ((left - middle.Column) * _nodes) + firstX + _reach + i;
                places[i] = (node % _nodes * _stride) + (node / _nodes);
            }

            for (int row = top; row <= bottom; row++)
            {
                int nodeY = ((row - middle.Row) * _nodes) + firstY + _reach;
                for (int column = left; column <= right; column += Vector256<double>.Count)
                {
                    Vector256<double> sums = Vector256<double>.Zero;
                    for (int j = 0; j < _order; j++)
                    {
                        ReadOnlySpan<double> ofNode = _table.AsSpan(((nodeY + j) * _nodes * _stride) + column - left);
                        Vector256<double> ofRow = Vector256<double>.Zero;
                        for (int i = 0; i < _order; i++)
                        {
                            ofRow += Vector256.Create(across[i]) * Vector256.Create(ofNode[places[i]..]);
                        }

                        sums += Vector256.Create(down[j]) * ofRow;
                    }

                    int count = Math.Min(Vector256<double>.Count, right - column + 1);
                    for (int lane = 0; lane < count; lane++)
                    {
                        double part = light * sums[lane];
                        pixels[(row * width) + column + lane] += part;
                        added += part;
                    }
                }
            }

            return added;
        }

        /// <summary>The table in the order in which it is read, with room for the last vector.</summary>
        private double[] SideBySide(double[] table)
        {
            int size = (2 * _reach) + 1;
            double[] ordered = new double[(size * _nodes * _stride) + Vector256<double>.Count];
            for (int row = 0; row < size; row++)
            {
                for (int column = 0; column < size; column++)
                {
                    ordered[(((row * _nodes) + (column % _nodes)) * _stride) + (column / _nodes)] = table[(row * size) + column];
                }
            }

            return ordered;
        }

        /// <summary>Lagrange's weights of the nodes around a pixel's centre that lies so far before the point.</summary>
        /// <param name="offset">Offset of the point from the middle of its pixel, px, -0.5 to 0.5.</param>
        /// <returns>The first node, from the point.</returns>
        private int Weights(double offset, Span<double> weights)
        {
            double place = -offset * _nodes;
            int first = (int)Math.Floor(place) - (_order / 2) + 1;
            double t = place - first;
            for (int i = 0; i < weights.Length; i++)
            {
                double weight = 1.0;
                for (int j = 0; j < weights.Length; j++)
                {
                    weight *= j == i ? 1.0 : (t - j) / (i - j);
                }

                weights[i] = weight;
            }

            return first;
        }

        /// <summary>Sums of the cells of a pixel around each node.</summary>
        private double[] Sums(double[] cells, int cellReach, double factor)
        {
            int half = _nodes / 2;
            int size = (2 * _reach) + 1;
            int cellSize = (2 * cellReach) + 1;
            double[] ofRows = new double[cellSize * size]; // sums along rows
            for (int row = 0; row < cellSize; row++)
            {
                for (int node = -_reach; node <= _reach; node++)
                {
                    double sum = 0.0;
                    for (int cell = Math.Max(-cellReach, node - half); cell <= Math.Min(cellReach, node + half); cell++)
                    {
                        sum += cells[(row * cellSize) + cell + cellReach];
                    }

                    ofRows[(row * size) + node + _reach] = sum;
                }
            }

            double[] table = new double[size * size];
            for (int node = -_reach; node <= _reach; node++)
            {
                Span<double> target = table.AsSpan((node + _reach) * size, size);
                for (int cell = Math.Max(-cellReach, node - half); cell <= Math.Min(cellReach, node + half); cell++)
                {
                    ReadOnlySpan<double> source = ofRows.AsSpan((cell + cellReach) * size, size);
                    for (int i = 0; i < size; i++)
                    {
                        target[i] += factor * source[i];
                    }
                }
            }

            return table;
        }
    }
}
