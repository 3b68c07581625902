using Msisf.Core.Terrain;

namespace Msisf.Core.Blocks;

/// <summary>Collects the facets of one mesh. A vertex that facets share is kept once; a facet of two equal corners is none.</summary>
/// <param name="stepsPerMetre">Steps per metre of the lattice on which all vertices lie, a power of two.</param>
internal sealed class BlockMeshBuilder(double stepsPerMetre)
{
    private readonly Dictionary<Vector3D, int> _numbers = [];
    private readonly List<Vector3D> _vertices = [];
    private readonly List<int> _faces = [];
    private Vector3D _low = new(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity);
    private Vector3D _high = new(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity);

    /// <summary>Whether the mesh is small enough for its lattice.</summary>
    public bool IsInReach => IsInReachAlong(_low.X, _high.X) && IsInReachAlong(_low.Y, _high.Y) && IsInReachAlong(_low.Z, _high.Z);

    /// <summary>Adds a facet.</summary>
    /// <param name="corners">m, body-fixed, counter-clockwise seen from outside.</param>
    public void Add((Vector3D A, Vector3D B, Vector3D C) corners)
    {
        (Vector3D a, Vector3D b, Vector3D c) = corners;
        if (a == b || b == c || c == a)
        {
            return; // at a pole a cell has one facet
        }

        _faces.Add(NumberOf(a));
        _faces.Add(NumberOf(b));
        _faces.Add(NumberOf(c));
    }

    /// <summary>The mesh, relative to the middle of its vertices.</summary>
    /// <exception cref="BadInputException">It is too large for its lattice.</exception>
    public BlockMesh Build()
    {
        if (!IsInReach)
        {
            throw TooLarge();
        }

        (long X, long Y, long Z) origin = (MiddleOf(_low.X, _high.X), MiddleOf(_low.Y, _high.Y), MiddleOf(_low.Z, _high.Z));
        int[] offsets = new int[3 * _vertices.Count];
        for (int vertex = 0; vertex < _vertices.Count; vertex++)
        {
            Vector3D steps = stepsPerMetre * _vertices[vertex];
            offsets[3 * vertex] = (int)((long)steps.X - origin.X);
            offsets[(3 * vertex) + 1] = (int)((long)steps.Y - origin.Y);
            offsets[(3 * vertex) + 2] = (int)((long)steps.Z - origin.Z);
        }

        return new BlockMesh(Math.ILogB(stepsPerMetre), origin, offsets, [.. _faces]);
    }

    private int NumberOf(Vector3D vertex)
    {
        if (!_numbers.TryGetValue(vertex, out int number))
        {
            number = _vertices.Count;
            _numbers.Add(vertex, number);
            _vertices.Add(vertex);
            _low = new Vector3D(Math.Min(_low.X, vertex.X), Math.Min(_low.Y, vertex.Y), Math.Min(_low.Z, vertex.Z));
            _high = new Vector3D(Math.Max(_high.X, vertex.X), Math.Max(_high.Y, vertex.Y), Math.Max(_high.Z, vertex.Z));
        }

        return number;
    }

    private bool IsInReachAlong(double low, double high) => !(stepsPerMetre * (high - low) > 2 * (BlockMesh.OffsetLimit - 1));

    private long MiddleOf(double low, double high) => (long)Math.Floor(0.5 * stepsPerMetre * (low + high));

    private BadInputException TooLarge()
    {
        SelenographicPoint point = SelenographicPoint.Below(_vertices[0]);
        return new BadInputException(Invariant(
            $"Around latitude {double.RadiansToDegrees(point.Latitude):F3}, longitude {double.RadiansToDegrees(point.Longitude):F3} "
                + $"degrees neighbouring facets reach over more than {2.0 * BlockMesh.OffsetLimit / stepsPerMetre:R} m, too far for "
                + $"POV-Ray's 32-bit numbers. Use --renderer native, or give a model of a resolution between those that meet there."));
    }
}

/// <summary>The facets of a <see cref="SceneBlock"/>, with vertices on a lattice.</summary>
/// <param name="LatticeExponent">k: the lattice has steps of 2^-k m.</param>
/// <param name="Origin">The point to which the vertices are relative, in steps, body-fixed.</param>
/// <param name="Offsets">x, y, z of each vertex from the origin, in steps; each below <see cref="OffsetLimit"/> in size.</param>
/// <param name="Faces">Three vertex numbers a facet, counter-clockwise seen from outside.</param>
public sealed record BlockMesh(int LatticeExponent, (long X, long Y, long Z) Origin, int[] Offsets, int[] Faces)
{
    /// <summary>Steps: whole numbers below this are exact as 32-bit floats, which POV-Ray keeps.</summary>
    public const int OffsetLimit = 1 << 24;

    /// <summary>Number of vertices.</summary>
    public int VertexCount => Offsets.Length / 3;

    /// <summary>Number of facets.</summary>
    public int FaceCount => Faces.Length / 3;
}
