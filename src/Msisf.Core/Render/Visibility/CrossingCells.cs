using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Visibility;

/// <summary>Draws facets that have corners behind the camera or so near to its plane that they can't be projected.</summary>
internal sealed class CrossingCells
{
    /// <summary>Parts of the coordinates of an edge's ends: an edge that meets the camera's plane nearer to its middle leads out on both sides.</summary>
    private const double MiddleOfPlane = 1e-6;

    private PictureView _view = null!;

    /// <summary>Takes a frame's camera.</summary>
    public void Begin(PictureView view) => _view = view;

    /// <summary>Draws a facet into the band.</summary>
    /// <param name="block">The facet's block.</param>
    /// <param name="first">Element of its first corner.</param>
    /// <param name="second">Of its second corner.</param>
    /// <param name="third">Of its third corner.</param>
    /// <param name="line">Line of its cell.</param>
    /// <param name="sampleAndHalf">As in <see cref="FacetRecord"/>.</param>
    /// <param name="band">Where to draw.</param>
    public void Draw(ProjectedBlock block, int first, int second, int third, int line, int sampleAndHalf, Band band)
    {
        Extent extent = new(_view);
        Vector3D a = extent.Add(At(block, first));
        Vector3D b = extent.Add(At(block, second));
        Vector3D c = extent.Add(At(block, third));
        extent.AddEdge(a, b);
        extent.AddEdge(b, c);
        extent.AddEdge(c, a);
        PixelRange pixels = extent.PixelsOf(band);
        if (pixels.IsEmpty)
        {
            return;
        }

        Vector3D normal = Vector3D.Cross(At(block, second) - At(block, first), At(block, third) - At(block, first));
        double inverse = 1.0 / Vector3D.Dot(normal, At(block, first) - _view.Remainder);
        double offset = Vector3D.Dot(normal, At(block, first) + (_view.Origin - _view.Anchor));
        FacetPlane plane = new(
            Vector3D.Dot(normal, _view.FirstRay) * inverse,
            Vector3D.Dot(normal, _view.RayPerColumn) * inverse,
            Vector3D.Dot(normal, _view.RayPerRow) * inverse,
            _view.Distance / extent.GreatestDepth,
            double.MaxValue);
        SpatialEdges edges = new(Corner(block, first), Corner(block, second), Corner(block, third), _view);
        FacetFill.Fill(ref edges, plane, pixels, new FacetRecord(normal, offset, line, sampleAndHalf), band);
    }

    private static Vector3D At(ProjectedBlock block, int index) =>
        new(block.Vertices.X[index], block.Vertices.Y[index], block.Vertices.Z[index]);

    private SpatialEdges.Corner Corner(ProjectedBlock block, int index) =>
        new(At(block, index) - _view.Remainder, block.X[index], block.Y[index], block.IsUsable(index, _view));

    /// <summary>The picture's part in which a facet may lie, from its corners in front and where its edges leave through the camera's plane.</summary>
    private struct Extent(PictureView view)
    {
        private double _left = double.PositiveInfinity;
        private double _right = double.NegativeInfinity;
        private double _top = double.PositiveInfinity;
        private double _bottom = double.NegativeInfinity;

        public double GreatestDepth { get; private set; } = 0.0;

        /// <summary>Adds a corner; returns its products with across, down and forward.</summary>
        public Vector3D Add(Vector3D corner)
        {
            Vector3D fromCamera = corner - view.Remainder;
            Vector3D inPicture = new(
                Vector3D.Dot(fromCamera, view.Across), Vector3D.Dot(fromCamera, view.Down), Vector3D.Dot(fromCamera, view.Forward));
            if (inPicture.Z > 0.0)
            {
                GreatestDepth = Math.Max(GreatestDepth, inPicture.Z);
                Widen((inPicture.X / inPicture.Z) + view.CentreX, ref _left, ref _right);
                Widen((inPicture.Y / inPicture.Z) + view.CentreY, ref _top, ref _bottom);
            }

            return inPicture;
        }

        public void AddEdge(Vector3D a, Vector3D b)
        {
            if (a.Z > 0.0 == b.Z > 0.0)
            {
                return;
            }

            double part = a.Z / (a.Z - b.Z);
            Open(a.X, b.X, part, ref _left, ref _right);
            Open(a.Y, b.Y, part, ref _top, ref _bottom);
        }

        /// <summary>One pixel wider, for rounding.</summary>
        public readonly PixelRange PixelsOf(Band band) => PixelRange.Within(_left - 1.0, _right + 1.0, _top - 1.0, _bottom + 1.0, band);

        private static void Widen(double value, ref double least, ref double greatest)
        {
            least = Math.Min(least, value);
            greatest = Math.Max(greatest, value);
        }

        private static void Open(double a, double b, double part, ref double least, ref double greatest)
        {
            double crossing = a + (part * (b - a));
            double middle = MiddleOfPlane * (Math.Abs(a) + Math.Abs(b));
            least = crossing < middle ? double.NegativeInfinity : least;
            greatest = crossing > -middle ? double.PositiveInfinity : greatest;
        }
    }
}
