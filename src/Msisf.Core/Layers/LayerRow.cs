using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;

namespace Msisf.Core.Layers;

/// <summary>
/// What the layers of one row are computed from, for each pixel that shows the surface. What several layers need is computed once, for the
/// first that asks. One object serves row after row; it is for one thread.
/// </summary>
/// <param name="meshPixelsPerDegree">
/// px/deg: resolution of the grid whose cells the facets count; null if it is not one of latitude and longitude.
/// </param>
/// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
internal sealed class LayerRow(IGroundTruth frame, int? meshPixelsPerDegree, double referenceRadius, SpectralBand band)
{
    private readonly TruthRow _truth = new();
    private VectorRow _points = VectorRow.OfLength(0);
    private VectorRow _normals = VectorRow.OfLength(0);
    private VectorRow _sight = VectorRow.OfLength(0);
    private VectorRow _toLight = VectorRow.OfLength(0);
    private double[] _sightLengths = [];
    private double[] _radii = [];
    private double[] _lightDistances = [];
    private double[] _normalLengths = [];
    private Known _known;
    private int _rowOfBand;

    [Flags]
    private enum Known
    {
        None = 0,
        Sight = 1,
        ToLight = 2,
        SightLengths = 4,
        Radii = 8,
        LightDistances = 16,
        NormalLengths = 32,
    }

    /// <summary>The camera of the row's band.</summary>
    public FrameCamera Camera { get; private set; } = null!;

    /// <summary>Component of each ray's direction along the optical axis.</summary>
    public double AxisLength { get; private set; }

    /// <summary>Position of the Sun, or of the lamp that replaces it, m.</summary>
    public Vector3D LightPositionBodyFixed { get; private set; }

    /// <summary>
    /// px/deg: resolution of the grid whose cells <see cref="Facets"/> count; null if it is not one of latitude and longitude.
    /// </summary>
    public int? MeshPixelsPerDegree { get; } = meshPixelsPerDegree;

    /// <summary>Tells where the heights of facets come from; null if all are those of one model.</summary>
    public FacetSources? Sources { get; init; }

    /// <summary>m: radius of the sphere over which heights are counted.</summary>
    public double ReferenceRadius { get; } = referenceRadius;

    /// <summary>W m^-2 sr^-1 nm^-1: radiance of the radiance factor 1; null if a lamp at the camera replaces the Sun.</summary>
    public double? RadianceOfUnitFactor { get; private set; }

    /// <summary>The row, from 0.</summary>
    public int Row { get; private set; }

    /// <summary>Number of pixels that show the surface.</summary>
    public int Count => _truth.Points.Count;

    /// <summary>The column of each pixel, from 0.</summary>
    public ReadOnlySpan<int> Columns => _truth.Points.Columns.AsSpan(0, Count);

    /// <summary>The facet of each pixel.</summary>
    public ReadOnlySpan<FacetId> Facets => _truth.Facets.AsSpan(0, Count);

    public ReadOnlySpan<PixelIllumination> Lights => _truth.Lights.AsSpan(0, Count);

    /// <summary>The ray parameter of each pixel's point, whose unit is the length of <see cref="Sight"/>.</summary>
    public double[] Parameters => _truth.Points.Parameters;

    /// <summary>Surface points, m, body-fixed.</summary>
    public VectorRow Points => _points;

    /// <summary>Normals of length 1, body-fixed.</summary>
    public VectorRow Normals => _normals;

    /// <summary>From the camera to the points: directions of the pixels' rays, body-fixed.</summary>
    public VectorRow Sight
    {
        get
        {
            if (Misses(Known.Sight))
            {
                Camera.FindDirections(_rowOfBand, Columns, _sight);
            }

            return _sight;
        }
    }

    /// <summary>m: from the points to the light.</summary>
    public VectorRow ToLight
    {
        get
        {
            VectorRow sight = Sight;
            if (Misses(Known.ToLight))
            {
                // Relative to the camera, so that a lamp at the camera lies exactly on the line of sight, however near the ground is.
                RowGeometry.FindRest(LightPositionBodyFixed - Camera.PositionBodyFixed, Parameters, sight, Count, _toLight);
            }

            return _toLight;
        }
    }

    /// <summary>Lengths of <see cref="Sight"/>.</summary>
    public double[] SightLengths => LengthsOf(Sight, Known.SightLengths, _sightLengths);

    /// <summary>m: from the Moon's centre to the points.</summary>
    public double[] Radii => LengthsOf(Points, Known.Radii, _radii);

    /// <summary>m: from the points to the light.</summary>
    public double[] LightDistances => LengthsOf(ToLight, Known.LightDistances, _lightDistances);

    /// <summary>Lengths of <see cref="Normals"/>, 1 but for rounding.</summary>
    public double[] NormalLengths => LengthsOf(Normals, Known.NormalLengths, _normalLengths);

    /// <summary>I/F of the row's pixels, the mean over the samples of each; empty if the renderer does not know it.</summary>
    public ReadOnlySpan<double> RadianceFactors => frame.RadianceFactorsOf(Row);

    /// <summary>The part of <see cref="RadianceFactors"/> that is light from the ground; empty if it was not asked for.</summary>
    public ReadOnlySpan<double> IndirectFactors => frame.IndirectFactorsOf(Row);

    /// <summary>Electrons in the detector's pixels, before noise; empty without a detector.</summary>
    public ReadOnlySpan<double> Electrons => frame.ElectronsOf(Row);

    /// <summary>Number of the crater that each of the row's pixels shows; empty without a catalogue.</summary>
    public ReadOnlySpan<int> CraterNumbers => OfRow(frame.CraterNumbers);

    /// <summary>Number of the object that each of the row's pixels shows; empty without a sky.</summary>
    public ReadOnlySpan<int> ObjectNumbers => OfRow(frame.ObjectNumbers);

    /// <summary>Saturation of the detector's pixels; empty without a detector.</summary>
    public ReadOnlySpan<byte> Saturated => frame.SaturatedOf(Row);

    /// <summary>Goes on to a row, from 0.</summary>
    public void MoveTo(int row)
    {
        Row = row;
        (PixelRows rows, FrameCamera camera) = frame.Camera.BandAt(row + 1);
        _rowOfBand = row - rows.First;
        if (camera != Camera)
        {
            (Camera, AxisLength) = (camera, camera.OpticalAxis.Length);
            SceneLight light = frame.Light.At(frame.Camera, row + 1);
            LightPositionBodyFixed = light.PositionBodyFixed;
            RadianceOfUnitFactor = light.IsSun ? band.RadianceOfUnitFactor(light.PositionBodyFixed.Length) : null;
        }

        frame.ReadRow(row + 1, _truth);
        _known = Known.None;
        int length = _truth.Points.X.Length;
        if (_radii.Length < length)
        {
            (_sight, _toLight) = (VectorRow.OfLength(length), VectorRow.OfLength(length));
            (_sightLengths, _radii) = (new double[length], new double[length]);
            (_lightDistances, _normalLengths) = (new double[length], new double[length]);
        }

        if (_points.X != _truth.Points.X)
        {
            _points = new VectorRow(_truth.Points.X, _truth.Points.Y, _truth.Points.Z);
            _normals = new VectorRow(_truth.Points.NormalX, _truth.Points.NormalY, _truth.Points.NormalZ);
        }
    }

    private ReadOnlySpan<T> OfRow<T>(ReadOnlySpan<T> image) => image.IsEmpty ? [] : image.Slice(Row * Camera.Width, Camera.Width);

    private double[] LengthsOf(VectorRow vectors, Known part, double[] lengths)
    {
        if (Misses(part))
        {
            LaneHypot.Lengths(vectors, Count, lengths);
        }

        return lengths;
    }

    /// <summary>Whether a part is still to be computed; from then on it counts as known.</summary>
    private bool Misses(Known part)
    {
        bool isMissing = (_known & part) == 0;
        _known |= part;
        return isMissing;
    }
}
