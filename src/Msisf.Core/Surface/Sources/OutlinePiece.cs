using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// A piece of the outlines of models: what of them lies in a cube, with the pieces in the cubes of half its side. Immutable once made.
/// </summary>
internal sealed class OutlinePiece
{
    private readonly List<OutlinePiece> _parts = [];
    private readonly double _side;
    private Vector3D _middle;
    private double _length;
    private double _height;
    private double _radius;

    private OutlinePiece(double side) => _side = side;

    /// <summary>Divides outlines into pieces.</summary>
    /// <param name="differences">At least one.</param>
    /// <param name="finest">m: side of the smallest cubes.</param>
    /// <returns>
    /// The piece that holds all others, and m: the greatest absolute value of a piece's mean, for each size from the smallest to that one.
    /// </returns>
    public static (OutlinePiece Whole, IReadOnlyList<double> Greatest) TreeOf(
        IReadOnlyList<OutlineDifference> differences, double finest)
    {
        CubeList pieces = new(finest);
        foreach (OutlineDifference one in differences)
        {
            OutlinePiece piece = pieces.At(Cube(one.Place.X), Cube(one.Place.Y), Cube(one.Place.Z));
            piece._middle += one.Length * one.Place;
            piece._length += one.Length;
            piece._height += one.Length * one.Height;
        }

        foreach ((_, OutlinePiece piece) in pieces.All)
        {
            piece._middle /= piece._length;
        }

        List<double> greatest = [Greatest(pieces)];
        for (double side = 2.0 * finest; pieces.All.Count > 1; side *= 2.0)
        {
            pieces = Joined(pieces, side);
            greatest.Add(Greatest(pieces));
        }

        return (pieces.All[0].Piece, greatest);

        static double Greatest(CubeList list) => list.All.Max(one => Math.Abs(one.Piece._height / one.Piece._length));

        // Counted from beyond all places, so that halving joins all cubes to one in the end.
        long Cube(double metres) => (long)Math.Floor((metres + (2.0 * MoonConstants.ReferenceRadius)) / finest);
    }

    /// <summary>Finds the nearest of the smallest pieces.</summary>
    /// <param name="place">m.</param>
    /// <param name="distance">m: how far to look; becomes the piece's distance.</param>
    /// <returns>Whether there is one.</returns>
    public bool FindNearest(Vector3D place, ref double distance)
    {
        double own = Distance(place);
        if (own - _radius >= distance)
        {
            return false;
        }

        if (_parts.Count == 0)
        {
            distance = own;
            return true;
        }

        // The nearest part first: it mostly leaves nothing to be found in the others.
        OutlinePiece first = _parts[0];
        double nearest = first.Distance(place);
        for (int i = 1; i < _parts.Count; i++)
        {
            double away = _parts[i].Distance(place);
            (first, nearest) = away < nearest ? (_parts[i], away) : (first, nearest);
        }

        bool isFound = first.FindNearest(place, ref distance);
        foreach (OutlinePiece part in _parts)
        {
            isFound |= part != first && part.FindNearest(place, ref distance);
        }

        return isFound;
    }

    /// <summary>Adds what lies within a distance.</summary>
    /// <param name="mean">The sums.</param>
    /// <param name="place">m.</param>
    /// <param name="around">m: the distance.</param>
    /// <param name="widest">m: side of the cubes that need not be divided.</param>
    public void AddTo(ref OutlineMean mean, Vector3D place, double around, double widest)
    {
        double squared = (place - _middle).LengthSquared;
        double reach = around + _radius;
        if (squared >= reach * reach)
        {
            return;
        }

        if (_parts.Count > 0 && _side > widest)
        {
            foreach (OutlinePiece part in _parts)
            {
                part.AddTo(ref mean, place, around, widest);
            }

            return;
        }

        double rest = Math.Max(0.0, 1.0 - (squared / (around * around)));
        double weight = rest * rest;
        mean = new OutlineMean(mean.Weight + (weight * _length), mean.Height + (weight * _height));
    }

    private static CubeList Joined(CubeList pieces, double side)
    {
        CubeList joined = new(side);
        foreach (((long x, long y, long z), OutlinePiece part) in pieces.All)
        {
            joined.At(x >> 1, y >> 1, z >> 1)._parts.Add(part);
        }

        foreach ((_, OutlinePiece whole) in joined.All)
        {
            foreach (OutlinePiece part in whole._parts)
            {
                whole._middle += part._length * part._middle;
                whole._length += part._length;
                whole._height += part._height;
            }

            whole._middle /= whole._length;
            whole._radius = whole._parts.Max(part => part.Distance(whole._middle) + part._radius);
        }

        return joined;
    }

    private double Distance(Vector3D place) => Math.Sqrt((place - _middle).LengthSquared);

    /// <summary>Pieces by their cubes, in the order in which they were first asked for.</summary>
    private sealed class CubeList(double side)
    {
        private readonly Dictionary<(long X, long Y, long Z), OutlinePiece> _pieces = [];

        public List<((long X, long Y, long Z) Cube, OutlinePiece Piece)> All { get; } = [];

        public OutlinePiece At(long x, long y, long z)
        {
            if (!_pieces.TryGetValue((x, y, z), out OutlinePiece? piece))
            {
                _pieces[(x, y, z)] = piece = new OutlinePiece(side);
                All.Add(((x, y, z), piece));
            }

            return piece;
        }
    }
}

/// <summary>Sums for the mean of the differences around a place.</summary>
/// <param name="Height">Sum of the differences with their weights, m.</param>
internal readonly record struct OutlineMean(double Weight, double Height);
