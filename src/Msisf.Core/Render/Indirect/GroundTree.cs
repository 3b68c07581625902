using System.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// The ground around a view, for very many rays: the nodes of the surface's tree as boxes, sixteen of them tested at once, down to facets,
/// tested eight at once. A node is looked into when the first ray comes to it. Its axes are body-fixed ones that are turned so that the
/// third one points up in the view. Safe for several threads; what a ray meets does not depend on other rays.
/// </summary>
internal sealed class GroundTree
{
    /// <summary>m: a way to a point ends so much before it.</summary>
    public const double Gap = 1e-3;

    private readonly Vector3D _east;
    private readonly Vector3D _north;
    private readonly Vector3D _up;
    private readonly GroundNode _root;

    /// <summary>Makes the tree of a surface; little of it is read yet.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="middle">Body-fixed direction of the view's middle, length 1.</param>
    public GroundTree(SurfaceModel surface, Vector3D middle)
    {
        Surface = surface;
        Origin = new Vector3D(OnLattice(middle.X), OnLattice(middle.Y), OnLattice(middle.Z));
        double OnLattice(double part) => Math.Round(surface.ReferenceRadius * part); // relative to it vertices are exact
        _up = middle;
        _east = Vector3D.Cross(Math.Abs(middle.Z) < 0.9 ? Vector3D.UnitZ : Vector3D.UnitX, middle).Normalized();
        _north = Vector3D.Cross(_up, _east);
        List<GroundPlace> places = [];
        for (int part = 0; part < surface.Patches.Length; part++)
        {
            BoundsLayout layout = surface.Patches[part].Layout;
            int top = layout.Levels - 1;
            for (int node = 0; !surface.Patches[part].IsLeftOut && node < layout.Rows(top) * layout.Columns(top); node++)
            {
                (int row, int column) = (node / layout.Columns(top), node % layout.Columns(top));
                AddPlaces(part, new NodePlace(top, row, column), places);
            }
        }

        _root = new GroundNode(this, places);
    }

    /// <summary>The surface.</summary>
    public SurfaceModel Surface { get; }

    /// <summary>m, body-fixed, on the lattice.</summary>
    public Vector3D Origin { get; }

    /// <summary>Turns a body-fixed vector into the tree's axes.</summary>
    public Vector3D Turned(Vector3D bodyFixed) =>
        new(Vector3D.Dot(_east, bodyFixed), Vector3D.Dot(_north, bodyFixed), Vector3D.Dot(_up, bodyFixed));

    /// <summary>Whether ground lies on a way.</summary>
    /// <param name="from">m, body-fixed, on the ground or above.</param>
    /// <param name="direction">Length 1, out of the ground.</param>
    /// <param name="length">m.</param>
    public bool IsBlocked(Vector3D from, Vector3D direction, double length)
    {
        GroundRay ray = new(Placed(from), Turned(direction), length, stopsAtAnyHit: true);
        _root.Meet(ref ray);
        return ray.IsHit;
    }

    /// <summary>Finds the first ground on a way; the parameters are those of <see cref="IsBlocked"/>.</summary>
    /// <returns>Its distance, m, and normal, length 1, body-fixed; null if there is none.</returns>
    public (double Distance, Vector3D Normal)? FirstGround(Vector3D from, Vector3D direction, double length)
    {
        GroundRay ray = new(Placed(from), Turned(direction), length, stopsAtAnyHit: false);
        _root.Meet(ref ray);
        if (!ray.IsHit)
        {
            return null;
        }

        Vector3D turned = ray.Normal / Math.Sqrt(ray.Normal.LengthSquared);
        return (ray.End, (turned.X * _east) + (turned.Y * _north) + (turned.Z * _up));
    }

    /// <summary>Prepares the ways from a group of points.</summary>
    public void Start(GroundFan fan, Receivers group)
    {
        for (int i = 0; i < group.Count; i++)
        {
            fan.Start(i, Placed(group.Points[i]));
        }
    }

    /// <summary>Which of some ways that were started get to a point, but for a last <see cref="Gap"/>, as bits.</summary>
    /// <param name="fan">The ways.</param>
    /// <param name="end">m, body-fixed.</param>
    /// <param name="ways">Which ways are asked for, as bits.</param>
    /// <param name="count">Number of the ways that were started.</param>
    public ulong Reach(GroundFan fan, Vector3D end, ulong ways, int count)
    {
        fan.Lead(Placed(end), ways, count);
        _root.Meet(fan, ways);
        return fan.Open;
    }

    /// <summary>Adds a node, or what finer models have left of a block.</summary>
    public void AddPlaces(int part, NodePlace node, List<GroundPlace> places)
    {
        Patch patch = Surface.Patches[part];
        bool isBlock = node.Level == SquareLayout.CellBlockLevel;
        (int first, int count) = isBlock ? patch.PiecesOf(new CellBlock(node.Row, node.Column) { Part = part }) : (0, 1);
        if (count == 0)
        {
            return;
        }

        NodeBounds bounds = isBlock ? patch.BoundsOf(node)
            : patch.TryGetKnown(node, out NodeBounds known) ? known : NodeBounds.Within(Surface.RadiusLimits);
        OrientedBox box = patch.BoxOf(node, bounds.Min, bounds.Max).Box;
        Vector3D centre = Placed(box.Centre);
        Vector3D reach = new(box.ReachAlong(_east), box.ReachAlong(_north), box.ReachAlong(_up));
        for (int piece = first; piece < first + count; piece++)
        {
            places.Add(new GroundPlace(part, node, piece, centre - reach, centre + reach));
        }
    }

    private Vector3D Placed(Vector3D pointBodyFixed) => Turned(pointBodyFixed - Origin);
}

/// <summary>A node of the surface with its box.</summary>
/// <param name="Part">Number of the patch.</param>
/// <param name="Node">The node.</param>
/// <param name="Piece">What finer models have left of a block (<see cref="CellBlock.Piece"/>).</param>
/// <param name="Low">Lower corner, m, in the tree's axes.</param>
/// <param name="High">Upper corner.</param>
internal readonly record struct GroundPlace(int Part, NodePlace Node, int Piece, Vector3D Low, Vector3D High);

/// <summary>A part of the ground that a ray may meet.</summary>
internal abstract class GroundPart
{
    /// <summary>Finds the facet that a ray meets.</summary>
    public abstract void Meet(ref GroundRay ray);

    /// <summary>Closes those of some ways that enter the ground.</summary>
    public abstract void Meet(GroundFan fan, ulong ways);
}

/// <summary>Up to sixteen parts of the ground in boxes; they are made when the first ray comes to them.</summary>
internal sealed class GroundNode : GroundPart
{
    private readonly GroundTree _tree;
    private readonly SixteenBoxes _boxes = new();
    private readonly GroundPart?[] _parts = new GroundPart?[SixteenBoxes.Count];
    private readonly GroundPlace[] _places;

    /// <summary>Makes a node of places; of more than sixteen, of such nodes.</summary>
    public GroundNode(GroundTree tree, List<GroundPlace> places)
    {
        _tree = tree;
        if (places.Count <= SixteenBoxes.Count)
        {
            _places = [.. places];
            for (int i = 0; i < _places.Length; i++)
            {
                _boxes.Set(i, _places[i].Low, _places[i].High);
            }

            return;
        }

        _places = [];
        int number = 0;
        foreach (GroundPlace[] slice in Quarters(places, place => place.Low.X + place.High.X))
        {
            foreach (GroundPlace[] group in Quarters(slice, place => place.Low.Y + place.High.Y))
            {
                _parts[number] = new GroundNode(tree, [.. group]);
                _boxes.Set(
                    number++,
                    new Vector3D(group.Min(place => place.Low.X), group.Min(place => place.Low.Y), group.Min(place => place.Low.Z)),
                    new Vector3D(group.Max(place => place.High.X), group.Max(place => place.High.Y), group.Max(place => place.High.Z)));
            }
        }
    }

    /// <inheritdoc/>
    public override void Meet(ref GroundRay ray)
    {
        for (uint parts = _boxes.Meet(ray); parts != 0 && !ray.IsOver; parts &= parts - 1)
        {
            int part = BitOperations.TrailingZeroCount(parts);
            PartAt(part).Meet(ref ray);
        }
    }

    /// <inheritdoc/>
    public override void Meet(GroundFan fan, ulong ways)
    {
        for (uint parts = _boxes.Meet(fan); parts != 0; parts &= parts - 1)
        {
            int part = BitOperations.TrailingZeroCount(parts);
            ulong some = _boxes.Meet(part, fan) & ways & fan.Open;
            if (some != 0)
            {
                PartAt(part).Meet(fan, some);
            }
        }
    }

    private static IEnumerable<GroundPlace[]> Quarters(IReadOnlyCollection<GroundPlace> places, Func<GroundPlace, double> key) =>
        places.OrderBy(key).Chunk((places.Count + 3) / 4);

    private GroundPart PartAt(int part) => Volatile.Read(ref _parts[part]) ?? Make(part);

    private GroundPart Make(int part)
    {
        GroundPlace place = _places[part];
        GroundPart made;
        if (place.Node.Level == SquareLayout.CellBlockLevel)
        {
            made = new GroundBlock(_tree, new CellBlock(place.Node.Row, place.Node.Column) { Part = place.Part, Piece = place.Piece });
        }
        else
        {
            List<GroundPlace> inside = [];
            BoundsLayout layout = _tree.Surface.Patches[place.Part].Layout;
            NodeRange children = layout.ChildrenOf(place.Node.Level, place.Node.Row, place.Node.Column);
            for (int row = children.FirstRow; row < children.EndRow; row++)
            {
                for (int column = children.FirstColumn; column < children.EndColumn; column++)
                {
                    _tree.AddPlaces(place.Part, new NodePlace(place.Node.Level - 1, row, column), inside);
                }
            }

            made = new GroundNode(_tree, inside);
        }

        return Interlocked.CompareExchange(ref _parts[part], made, null) ?? made;
    }
}
