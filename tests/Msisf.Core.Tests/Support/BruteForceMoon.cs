using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Core.Tests.Support;

/// <summary>
/// Rays against each facet of the whole Moon in double precision, as plainly as that goes: a tree of boxes over the cells, then
/// Moeller and Trumbore. Shares nothing with the program but the rule for cells and poles, which it writes out for itself.
/// </summary>
internal sealed class BruteForceMoon
{
    /// <summary>Parts of a facet: rays through an edge or a corner hit it.</summary>
    private const double EdgeTolerance = 1e-12;

    private readonly int _lines;
    private readonly int _samples;
    private readonly int _cellsPerTile;
    private readonly int _columns;
    private readonly Vector3D[] _vertices;
    private readonly List<Box[]> _levels = [];
    private readonly List<(int Rows, int Columns)> _sizes = [];

    /// <param name="grid">The model.</param>
    /// <param name="subdivisions">"Tiles" are so many times smaller along an edge.</param>
    public BruteForceMoon(IGlobalGrid grid, int subdivisions = 1)
    {
        _lines = 180 * grid.PixelsPerDegree;
        _samples = 360 * grid.PixelsPerDegree;
        _cellsPerTile = 5 * grid.PixelsPerDegree / subdivisions;
        _columns = TileId.Columns * subdivisions;
        _vertices = MakeVertices(grid);
        MakeLeaves();
        while (_levels[^1].Length > 1)
        {
            MakeParents();
        }
    }

    /// <summary>Tiles of the Moon.</summary>
    public int TileCount => _lines / _cellsPerTile * _columns;

    /// <summary>Row of cells from the northern fan (0), column, and which of the two facets.</summary>
    public readonly record struct FacetId(int Row, int Column, int Half);

    /// <summary>The first facet on a ray.</summary>
    /// <param name="origin">m.</param>
    /// <param name="direction">Any length.</param>
    /// <param name="isThere">Which tiles are in the scene; null: all.</param>
    /// <param name="minT">Hits before this many lengths of the direction do not count.</param>
    public (FacetId Facet, double T)? FirstHit(Vector3D origin, Vector3D direction, bool[]? isThere = null, double minT = 0.0)
    {
        Vector3D inverse = new(1.0 / direction.X, 1.0 / direction.Y, 1.0 / direction.Z);
        (FacetId Facet, double T)? best = null;
        Descend(_levels.Count - 1, 0, 0, origin, direction, inverse, isThere, minT, ref best);
        return best;
    }

    /// <summary>Whether anything lies between a point on a facet and the light.</summary>
    public bool IsShadowed(FacetId facet, Vector3D point, Vector3D light, bool[]? isThere = null)
    {
        Vector3D toLight = light - point;

        // 1 mm off the surface: the point itself is rounded to some 1e-9 m.
        double start = 1e-3 / toLight.Length;
        (FacetId Facet, double T)? hit = FirstHit(point, toLight, isThere, start);
        return hit is not null && hit.Value.T < 1.0 && hit.Value.Facet != facet;
    }

    /// <summary>Tile by row (0 northernmost) times the tiles around the Moon plus column.</summary>
    public int TileOf(FacetId facet) =>
        (Math.Max(facet.Row - 1, 0) / _cellsPerTile * _columns) + (facet.Column / _cellsPerTile);

    public Vector3D Normal(FacetId facet)
    {
        (Vector3D a, Vector3D b, Vector3D c) = Corners(facet.Row, facet.Column, facet.Half);
        return Vector3D.Cross(b - a, c - a).Normalized();
    }

    public (Vector3D A, Vector3D B, Vector3D C) Corners(int row, int column, int half)
    {
        int next = column + 1 == _samples ? 0 : column + 1;
        Vector3D northWest = _vertices[(row * _samples) + column];
        Vector3D southEast = _vertices[((row + 1) * _samples) + next];
        return half == 0
            ? (northWest, _vertices[((row + 1) * _samples) + column], southEast)
            : (northWest, southEast, _vertices[(row * _samples) + next]);
    }

    private static double Rounded(double metres) => Math.Round(metres * 128.0) / 128.0;

    private Vector3D[] MakeVertices(IGlobalGrid grid)
    {
        Vector3D[] vertices = new Vector3D[(_lines + 2) * _samples];
        double[] radii = new double[_samples];
        for (int row = 0; row < _lines + 2; row++)
        {
            bool pole = row == 0 || row == _lines + 1;
            grid.ReadRadii(Math.Clamp(row - 1, 0, _lines - 1), 0, radii);
            double mean = radii.Average();
            double latitude = pole ? (row == 0 ? 0.5 : -0.5) * Math.PI : (90.0 - ((row - 0.5) / grid.PixelsPerDegree)) * Math.PI / 180.0;
            for (int sample = 0; sample < _samples; sample++)
            {
                double longitude = (sample + 0.5) / grid.PixelsPerDegree * Math.PI / 180.0;
                Vector3D v = (pole ? mean : radii[sample]) * new SelenographicPoint(latitude, longitude).ToDirectionBodyFixed();
                vertices[(row * _samples) + sample] = pole
                    ? new Vector3D(0.0, 0.0, Rounded(v.Z))
                    : new Vector3D(Rounded(v.X), Rounded(v.Y), Rounded(v.Z));
            }
        }

        return vertices;
    }

    private void MakeLeaves()
    {
        int rows = _lines + 1;
        Box[] boxes = new Box[rows * _samples];
        for (int row = 0; row < rows; row++)
        {
            for (int column = 0; column < _samples; column++)
            {
                (Vector3D a, Vector3D b, Vector3D c) = Corners(row, column, 0);
                (_, _, Vector3D d) = Corners(row, column, 1);
                boxes[(row * _samples) + column] = Box.Of(a).With(Box.Of(b)).With(Box.Of(c)).With(Box.Of(d));
            }
        }

        _levels.Add(boxes);
        _sizes.Add((rows, _samples));
    }

    private void MakeParents()
    {
        Box[] children = _levels[^1];
        (int childRows, int childColumns) = _sizes[^1];
        int rows = (childRows + 1) / 2;
        int columns = (childColumns + 1) / 2;
        Box[] boxes = new Box[rows * columns];
        for (int index = 0; index < boxes.Length; index++)
        {
            int row = index / columns * 2;
            int column = index % columns * 2;
            Box box = children[(row * childColumns) + column];
            for (int child = 1; child < 4; child++)
            {
                int r = row + (child / 2);
                int c = column + (child % 2);
                box = r < childRows && c < childColumns ? box.With(children[(r * childColumns) + c]) : box;
            }

            boxes[index] = box;
        }

        _levels.Add(boxes);
        _sizes.Add((rows, columns));
    }

    private void Descend(
        int level, int row, int column, Vector3D origin, Vector3D direction, Vector3D inverse, bool[]? isThere, double minT,
        ref (FacetId Facet, double T)? best)
    {
        (int rows, int columns) = _sizes[level];
        if (row >= rows || column >= columns
            || !_levels[level][(row * columns) + column].MayMeet(origin, inverse, best?.T ?? double.PositiveInfinity))
        {
            return;
        }

        if (level > 0)
        {
            for (int child = 0; child < 4; child++)
            {
                Descend(
                    level - 1, (2 * row) + (child / 2), (2 * column) + (child % 2), origin, direction, inverse, isThere, minT, ref best);
            }

            return;
        }

        if (isThere is not null && !isThere[TileOf(new FacetId(row, column, 0))])
        {
            return;
        }

        for (int half = 0; half < 2; half++)
        {
            if ((row == 0 && half == 1) || (row == _lines && half == 0))
            {
                continue; // two corners on the pole: no area
            }

            (Vector3D a, Vector3D b, Vector3D c) = Corners(row, column, half);
            double t = Meet(origin, direction, a, b, c);
            if (t >= minT && t < (best?.T ?? double.PositiveInfinity))
            {
                best = (new FacetId(row, column, half), t);
            }
        }
    }

    /// <summary>T. Moeller, B. Trumbore, J. Graphics Tools 2 (1997) 21, both sides; NaN if there is no hit.</summary>
    private static double Meet(Vector3D origin, Vector3D direction, Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D ab = b - a;
        Vector3D ac = c - a;
        Vector3D p = Cross(direction, ac);
        double determinant = Vector3D.Dot(ab, p);
        Vector3D fromA = origin - a;
        double u = Vector3D.Dot(fromA, p) / determinant;
        Vector3D q = Cross(fromA, ab);
        double v = Vector3D.Dot(direction, q) / determinant;
        return u >= -EdgeTolerance && v >= -EdgeTolerance && u + v <= 1.0 + EdgeTolerance
            ? Vector3D.Dot(ac, q) / determinant
            : double.NaN;
    }

    private static Vector3D Cross(Vector3D u, Vector3D v) =>
        new((u.Y * v.Z) - (u.Z * v.Y), (u.Z * v.X) - (u.X * v.Z), (u.X * v.Y) - (u.Y * v.X));

    private readonly record struct Box(Vector3D Low, Vector3D High)
    {
        public static Box Of(Vector3D point) => new(point, point);

        public Box With(Box other) => new(
            new Vector3D(Math.Min(Low.X, other.Low.X), Math.Min(Low.Y, other.Low.Y), Math.Min(Low.Z, other.Low.Z)),
            new Vector3D(Math.Max(High.X, other.High.X), Math.Max(High.Y, other.High.Y), Math.Max(High.Z, other.High.Z)));

        public bool MayMeet(Vector3D origin, Vector3D inverse, double farthest)
        {
            double near = 0.0;
            double far = farthest;
            Narrow(Low.X, High.X, origin.X, inverse.X, ref near, ref far);
            Narrow(Low.Y, High.Y, origin.Y, inverse.Y, ref near, ref far);
            Narrow(Low.Z, High.Z, origin.Z, inverse.Z, ref near, ref far);
            return near <= far * (1.0 + 1e-12);
        }

        private static void Narrow(double low, double high, double origin, double inverse, ref double near, ref double far)
        {
            // 1 mm wider than the facets; a ray along the slab gives infinities, or NaN on its border, which Min and Max must not take.
            double a = (low - 1e-3 - origin) * inverse;
            double b = (high + 1e-3 - origin) * inverse;
            double first = a < b ? a : b;
            double second = a < b ? b : a;
            near = first > near ? first : near;
            far = second < far ? second : far;
        }
    }
}
