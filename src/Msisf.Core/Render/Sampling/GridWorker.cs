using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Sampling;

/// <summary>A frame whose pixels all have the samples of a grid.</summary>
/// <param name="Blocks">The blocks that the frame may show.</param>
/// <param name="Samples">The projection to the samples.</param>
/// <param name="Light">The light on pieces of facets.</param>
/// <param name="SunBodyFixed">The Sun's centre, m, body-fixed.</param>
/// <param name="Options">The settings.</param>
/// <param name="RadianceFactors">Receives the brightness of the pixels.</param>
internal sealed record GridFrame(
    SurfaceModel Surface, IReadOnlyList<VisibleBlock> Blocks, ImageView Samples, SureLight Light, Vector3D SunBodyFixed,
    NativeRenderOptions Options, double[] RadianceFactors);

/// <summary>
/// Draws rows of pixels whose samples are a grid: as the pixels of a finer image. The brightness of a facet is found once, and so is its
/// light where the whole facet, or its part in a pixel, has the same. One object is for one thread.
/// </summary>
internal sealed class GridWorker
{
    /// <summary>Maximum number of samples along a pixel's edge: as many as are compared at once.</summary>
    public const int MaxAcross = 8;

    /// <summary>Brightness of facets whose points may differ in their light.</summary>
    private const double Unsure = double.NaN;

    /// <summary>
    /// Planes that rays meet at a smaller sine are left to the single samples: there the points are not sure to a millimetre.
    /// </summary>
    private const double MinSine = 1e-4;

    /// <summary>
    /// A facet whose length is a larger part of the distance to the Sun is left to the single samples: the angle to the Sun is not the
    /// same.
    /// </summary>
    private const double MaxLength = 3e-7;

    private readonly BandWorker _worker = new();
    private readonly Band _band;
    private GridFrame _frame = null!;
    private (double Factor, double IfLit)[] _facets = new (double, double)[1]; // of each facet, after those of no facet
    private int[] _numbers = []; // of each facet among those of the other samples

    public GridWorker() => _band = new Band(FindFactor);

    /// <summary>Draws rows of pixels, and adds up the brightness of their samples as far as it is sure.</summary>
    /// <param name="firstRow">First row, from 0.</param>
    /// <param name="others">The other samples are added to it, each a part of its own.</param>
    public void Draw(GridFrame frame, int firstRow, int rows, PixelParts others)
    {
        _frame = frame;
        ImageView view = frame.Samples;
        int across = view.PerAxis;
        _band.Begin(across * view.Camera.Width, across * firstRow, across * rows);
        _band.ClearFacets();
        _worker.Draw(frame.Surface, view, frame.Blocks, _band);
        if (_numbers.Length < _facets.Length)
        {
            _numbers = new int[_facets.Length];
        }

        _numbers.AsSpan(0, _band.Records.Count).Fill(Band.NotRecorded);
        Gather(firstRow, rows, others);
    }

    /// <summary>Finds the brightness of the facet that was recorded last.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void FindFactor(ProjectedBlock block, int index, int half)
    {
        int count = _band.Records.Count;
        if (_facets.Length <= count)
        {
            Array.Resize(ref _facets, count + (count / 2) + 1);
        }

        Vector3D normal = _band.Records[count - 1].Normal;
        Vector3D origin = _frame.Samples.Origin;
        Vector3D a = origin + block.At(index);
        Vector3D b = origin + block.At(index + FacetCorners.Second(half));
        Vector3D c = origin + block.At(index + FacetCorners.Third(half));
        Vector3D toSun = _frame.SunBodyFixed - ((1.0 / 3.0) * (a + b + c));
        double distance = Math.Sqrt(toSun.LengthSquared);
        double cosine = Vector3D.Dot(normal, toSun) / (Math.Sqrt(normal.LengthSquared) * distance);
        double reach = MaxLength * distance;
        ref (double Factor, double IfLit) facet = ref _facets[count];
        if (!(Math.Abs(cosine) >= Tolerances.FacingOfFacet)
            || !(Math.Max((b - a).LengthSquared, (c - a).LengthSquared) < reach * reach))
        {
            facet = (Unsure, Unsure);
        }
        else if (cosine < 0.0)
        {
            facet = (0.0, 0.0);
        }
        else
        {
            double lit = _frame.Options.Reflectance.RadianceFactor(Math.Min(cosine, 1.0), cosEmission: 1.0, phaseHaversine: 0.0);
            PieceLight light = _frame.Light.Of(
                Vector256.Create(a.X, b.X, c.X, c.X), Vector256.Create(a.Y, b.Y, c.Y, c.Y), Vector256.Create(a.Z, b.Z, c.Z, c.Z));
            facet = (FactorOf(light, lit), lit);
        }
    }

    private static double FactorOf(PieceLight light, double lit) =>
        light == PieceLight.Lit ? lit : light == PieceLight.Dark ? 0.0 : Unsure;

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Gather(int firstRow, int rows, PixelParts others)
    {
        int width = _frame.Samples.Camera.Width;
        int across = _frame.Samples.PerAxis;
        uint wanted = (1u << across) - 1;
        int count = across * across;
        double weight = 1.0 / count;
        int stride = _band.Stride;
        int height = across * stride;
        ReadOnlySpan<int> facets = _band.Facets;
        (double Factor, double IfLit)[] factors = _facets;
        for (int row = firstRow; row < firstRow + rows; row++)
        {
            int start = _band.IndexOf(0, across * row);
            for (int column = 0; column < width; column++, start += across)
            {
                int own = ArrayLanes.At(facets, start);
                Vector256<int> all = Vector256.Create(own);
                uint same = wanted;
                for (int first = start; first < start + height; first += stride)
                {
                    // Behind each row there is room for a whole vector.
                    same &= Vector256.Equals(ArrayLanes.Load256(facets, first), all).ExtractMostSignificantBits();
                }

                double sum = 0.0;
                if (same == wanted)
                {
                    sum = count * ArrayLanes.At(factors, own + 1).Factor;
                }
                else
                {
                    for (int first = start; first < start + height; first += stride)
                    {
                        for (int sample = first; sample < first + across; sample++)
                        {
                            sum += ArrayLanes.At(factors, ArrayLanes.At(facets, sample) + 1).Factor;
                        }
                    }
                }

                if (double.IsNaN(sum))
                {
                    sum = GatherUnsure(column, row, start, others);
                }

                _frame.RadianceFactors[(row * width) + column] = weight * sum;
            }
        }
    }

    /// <summary>Adds up the brightness of the samples of a pixel of which some are on facets that may be partly in shadow.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private double GatherUnsure(int column, int row, int start, PixelParts others)
    {
        CameraModel model = _frame.Samples.Camera.Model;
        int across = _frame.Samples.PerAxis;
        double sum = 0.0;
        int known = Band.NotRecorded;
        double factor = 0.0;
        others.EnsureRoom(across * across);
        for (int line = 0; line < across; line++)
        {
            int first = start + (line * _band.Stride);
            for (int sample = 0; sample < across; sample++)
            {
                int facet = _band.Facets[first + sample];
                if (facet != known)
                {
                    known = facet;
                    (factor, double lit) = _facets[facet + 1];
                    if (double.IsNaN(factor) && !double.IsNaN(lit))
                    {
                        factor = FactorOf(LightOf(column, row, _band.Records[facet]), lit);
                    }
                }

                if (!double.IsNaN(factor))
                {
                    sum += factor;
                    continue;
                }

                ref int number = ref _numbers[facet];
                if (number == Band.NotRecorded)
                {
                    number = others.Add(_band.Records[facet]);
                }

                others.Add(
                    (row * model.Width) + column, number, 1.0 / (across * across), _band.InverseDepths[first + sample],
                    column + (((sample + 0.5) / across) - 0.5), row + (((line + 0.5) / across) - 0.5), model);
            }
        }

        return sum;
    }

    /// <summary>The light on what a pixel shows of a facet's plane.</summary>
    private PieceLight LightOf(int column, int row, in FacetRecord record)
    {
        ImageView view = _frame.Samples;
        int last = view.PerAxis - 1;
        double left = column * view.PerAxis;
        double top = row * view.PerAxis;
        Vector256<double> columns = Vector256.Create(left, left + last, left, left + last);
        Vector256<double> rows = Vector256.Create(top, top, top + last, top + last);
        Vector256<double> x = Vector256.Create(view.FirstRay.X) + (columns * view.RayPerColumn.X) + (rows * view.RayPerRow.X);
        Vector256<double> y = Vector256.Create(view.FirstRay.Y) + (columns * view.RayPerColumn.Y) + (rows * view.RayPerRow.Y);
        Vector256<double> z = Vector256.Create(view.FirstRay.Z) + (columns * view.RayPerColumn.Z) + (rows * view.RayPerRow.Z);
        Vector3D camera = view.Camera.PositionBodyFixed;
        Vector3D normal = record.Normal;
        Vector256<double> perRay = (normal.X * x) + (normal.Y * y) + (normal.Z * z);
        double height = record.Offset - Vector3D.Dot(normal, camera - view.Anchor);
        Vector256<double> length = (x * x) + (y * y) + (z * z);
        if (!Vector256.LessThanAll(perRay, Vector256<double>.Zero) || !(height < 0.0)
            || !Vector256.GreaterThanAll(perRay * perRay, length * (MinSine * MinSine * normal.LengthSquared)))
        {
            return PieceLight.Unsure;
        }

        Vector256<double> parameter = Vector256.Create(height) / perRay;
        return _frame.Light.Of(
            Vector256.Create(camera.X) + (parameter * x), Vector256.Create(camera.Y) + (parameter * y),
            Vector256.Create(camera.Z) + (parameter * z));
    }
}
