using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Layers;

public class LayerSamplerTests
{
    private static readonly LayerProvenance Provenance = new("LDEM_4", 4, 0, "native", SpectralBand.Default);

    private static readonly Vector3D Sun = 1.5e11 * new Vector3D(0.6, 0.8, 0.0);

    [Fact]
    public void SampleRow_ReferenceScenes_MeetsMpmath()
    {
        foreach (ReferenceLayers expected in ReferenceLayers.Read())
        {
            double[] actual = PixelOf(new SphereTruth(expected.Camera, expected.Sun, 4), expected.X, expected.Y, ReferenceLayers.Names);

            Assert.Equal(expected.Values.Count, actual.Length);
            for (int i = 0; i < actual.Length; i++)
            {
                double tolerance = i switch
                {
                    < 6 => 4e-9, // m: some ulps of 1e7 m, the farthest camera
                    < 9 => 1e-9, // degrees: what the layers promise
                    _ => 1e-5 * expected.Values[i], // the first-order formula on pixels up to 2e-3 rad wide
                };
                Assert.True(
                    Math.Abs(expected.Values[i] - actual[i]) <= tolerance,
                    $"{expected.Scene}, value {i}: {actual[i]:R}, expected {expected.Values[i]:R}");
            }
        }
    }

    [Fact]
    public void SampleRow_LatitudeLongitudeAndDirection_AreThoseOfTheMetaFileToTheBit()
    {
        PinholeCamera camera = NadirCamera(33, 21);
        SphereTruth truth = new(camera, Sun, 4);
        PixelSampler pixels = new(camera, new PixelGrid(33, 21, 1, 1), ReferenceSphere.Lola, truth.Light);
        double[][] planes = Sample(truth, "latitude", "longitude", "illumination-direction");

        Assert.Equal(pixels.Sample().Count(), planes[0].Count(double.IsFinite));
        foreach (PixelRecord record in pixels.Sample())
        {
            int i = ((record.V - 1) * 33) + record.H - 1;
            Assert.Equal(double.RadiansToDegrees(record.Point.Latitude), planes[0][i]);
            Assert.Equal(double.RadiansToDegrees(record.Point.Longitude), planes[1][i]);
            Assert.Equal(double.RadiansToDegrees(record.IlluminationDirection!.Value), planes[2][i]);
        }
    }

    [Theory]
    [InlineData(12.5, 0.0)]
    [InlineData(30.0, 90.0)]
    [InlineData(5.0, 200.0)]
    [InlineData(1e-3, 359.0)]
    public void SampleRow_InclinedGround_HasItsSlopeAndAspect(double slope, double aspect)
    {
        // At 30 N 40 E; the normal leans towards the azimuth in which the ground falls.
        (double sinSlope, double cosSlope) = Math.SinCos(double.DegreesToRadians(slope));
        (double sinAspect, double cosAspect) = Math.SinCos(double.DegreesToRadians(aspect));
        (double sin30, double cos30) = Math.SinCos(Math.PI / 6.0);
        (double sin40, double cos40) = Math.SinCos(double.DegreesToRadians(40.0));
        Vector3D up = new(cos30 * cos40, cos30 * sin40, sin30);
        Vector3D east = new(-sin40, cos40, 0.0);
        Vector3D north = new(-sin30 * cos40, -sin30 * sin40, cos30);
        Vector3D normal = (cosSlope * up) + (sinSlope * ((sinAspect * east) + (cosAspect * north)));

        double[] values = PixelOf(TruthOf(1.74e6 * up, normal), 1, 1, "slope", "aspect");

        Assert.Equal(slope, values[0], Rounding.OfPlaces);
        Assert.Equal(aspect, values[1], 1e-6);
    }

    [Theory]
    [InlineData(0.0, false)]
    [InlineData(0.0, true)]
    [InlineData(7.0, false)]
    public void SampleRow_PrincipalPointOffTheMiddle_DepthIsTheThirdCoordinateInTheCamera(double skew, bool hasLens)
    {
        Distortion? lens = hasLens ? new OpenCvDistortion([0.1], []) : null;
        CameraModel model = new(33, 21, (30.0, 32.0), (4.0, 27.0), skew, lens);
        FrameCamera camera = model.At(new CameraState(new Vector3D(3e6, 0.0, 0.0), UnitQuaternion.Identity));
        CameraMatrix matrix = CameraMatrix.Of(camera);

        double[][] planes = Sample(new SphereTruth(camera, Sun, 4), "depth", "position");

        Assert.Contains(planes[0], double.IsFinite);
        for (int i = 0; i < planes[0].Length; i++)
        {
            Vector3D inCamera = (matrix.Rotation * new Vector3D(planes[1][i], planes[2][i], planes[3][i])) + matrix.Translation;
            Assert.Equal(inCamera.Z, planes[0][i], Rounding.OfConvertedPlaces);
        }
    }

    [Fact]
    public void SampleRow_SphereIncidence_IsThatOfTheSmoothSphere()
    {
        double[][] planes = Sample(new SphereTruth(NadirCamera(21, 21), Sun, 4), "incidence", "sphere-incidence");

        Assert.Contains(planes[1], double.IsFinite);
        for (int i = 0; i < planes[0].Length; i++)
        {
            Assert.Equal(planes[0][i], planes[1][i], Rounding.OfPlaces);
        }
    }

    [Fact]
    public void SampleRow_LevelGroundOrPole_HasNoAspect()
    {
        Assert.Equal([0.0, double.NaN], PixelOf(TruthOf(1.7e6 * Vector3D.UnitX, Vector3D.UnitX), 1, 1, "slope", "aspect"));
        Assert.Equal([90.0, double.NaN], PixelOf(TruthOf(1.7e6 * Vector3D.UnitZ, Vector3D.UnitX), 1, 1, "slope", "aspect"));
    }

    [Fact]
    public void SampleRow_Brightness_IsTheImagesAlsoBesideTheMoon()
    {
        FunctionTruth truth = new(NadirCamera(2, 1), 149_597_870_700.0 * Vector3D.UnitX, (_, _) => null) { Factors = [0.1, 0.0] };
        double[][] planes = [new double[2], new double[2], new double[2]];

        new LayerSampler(truth, Provenance).SampleRow(0, LayerSet.Parse("slope,radiance-factor,radiance").Layers, planes, start: 0);

        Assert.All(planes[0], value => Assert.Equal(double.NaN, value));
        Assert.Equal([0.1, 0.0], planes[1]);
        Assert.Equal(0.1 * 0.515662, planes[2][0], 1e-6); // 1.620 W m^-2 nm^-1 over pi
    }

    [Fact]
    public void SampleRow_CentrePixel_HasTheClosedFormValues()
    {
        // Straight down from 4e6 m on a sphere of 1.7e6 m; the Sun 53.13... degrees (3-4-5 triangle) from the zenith.
        const double radius = 1.7e6;
        SphereTruth truth = new(NadirCamera(3, 3), Sun, 4, radius);
        string[] names = [.. LayerCatalogue.All.Select(layer => layer.Name)];

        Dictionary<string, double[]> values = [];
        double[] all = PixelOf(truth, 2, 2, names);
        int next = 0;
        foreach (Layer layer in LayerCatalogue.All)
        {
            values[layer.Name] = all[next..(next += layer.Planes)];
        }

        Assert.Equal(4e6 - radius, Assert.Single(values["depth"]), Rounding.OfPlaces);
        Assert.Equal([4e6 - radius], values["range"]);
        Assert.Equal([radius, 0.0, 0.0], values["position"]);
        Assert.Equal([0.0], values["latitude"]);
        Assert.Equal([0.0], values["longitude"]);
        Assert.Equal([radius - 1_737_400.0], values["height"]);
        Assert.Equal([1.0, 0.0, 0.0], values["normal"]);
        double fromPoint = Math.Atan2(0.8 * 1.5e11, (0.6 * 1.5e11) - radius) * 180.0 / Math.PI;
        Assert.Equal(fromPoint, Assert.Single(values["incidence"]), Rounding.OfChains);
        Assert.Equal([0.0], values["emission"]);
        Assert.Equal(fromPoint, Assert.Single(values["phase"]), Rounding.OfChains);
        Assert.Equal(90.0, Assert.Single(values["illumination-direction"]), 1e-12); // the Sun is in the east, which is right
        Assert.Equal([1.0], values["mask"]);
        Assert.Equal([1.0], values["sun-visibility"]);
        Assert.Equal([(18 * 72) + 71.0], values["tile"]); // samples lie half a step off (0, 0): its cell begins north-west of it
        Assert.Equal([359.0, 1439.0], values["cell"]);
        Assert.Equal((4e6 - radius) * 2.0 * Math.Tan(0.5) / 3.0, Assert.Single(values["pixel-scale"]), 1e-6);
    }

    [Fact]
    public void SampleRow_PixelWithoutSurface_IsUndefinedAndMasked0()
    {
        PinholeCamera away = new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, Math.PI), 1.0, 2, 2);

        double[][] planes = Sample(new SphereTruth(away, Sun, 4), [.. LayerCatalogue.All.Select(layer => layer.Name)]);

        Assert.Equal(34, planes.Length);
        Assert.Equal(3, planes.Count(plane => plane.All(value => value == 0.0))); // mask, saturated and object
        Assert.Equal(31, planes.Count(plane => plane.All(double.IsNaN)));
    }

    [Fact]
    public void SampleRow_SunInTheZenith_HasNoDirectionAndIncidence0()
    {
        SphereTruth truth = new(NadirCamera(1, 1), new Vector3D(1.5e11, 0.0, 0.0), 4);

        Assert.Equal([double.NaN, 0.0, 0.0], PixelOf(truth, 1, 1, "incidence", "phase", "illumination-direction").Order());
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(1e6)]
    public void SampleRow_LampAtTheCamera_PhaseIs0AndIncidenceIsEmission(double altitude)
    {
        Vector3D position = new(1_737_400.0 + altitude, 0.0, 0.0);
        SphereTruth truth = new(new PinholeCamera(position, UnitQuaternion.Identity, 0.7, 16, 16), position, 4);

        double[] values = PixelOf(truth, 3, 14, "phase", "incidence", "emission");

        Assert.Equal(values[0], values[1], 1e-13); // in the order of the catalogue: incidence, emission, phase
        Assert.InRange(values[0], 1.0, 90.0);
        Assert.Equal(0.0, values[2], 1e-13);
    }

    [Fact]
    public void SampleRow_NightSide_IncidenceIsBeyond90AndMaskNight()
    {
        SphereTruth truth = new(NadirCamera(1, 1), new Vector3D(-1.5e11, 1e6, 0.0), 4);

        double[] values = PixelOf(truth, 1, 1, "incidence", "mask", "sun-visibility");

        Assert.InRange(values[0], 179.999, 180.0);
        Assert.Equal([(double)IlluminationState.Night, 0.0], values[1..]);
    }

    [Theory]
    [InlineData(90.0, 0.3, 85, 0)] // the northern fan
    [InlineData(89.9, 359.99, 85, 355)]
    [InlineData(84.87, 4.87, 80, 0)] // the last samples before both borders are half a step away
    [InlineData(84.88, 5.13, 85, 5)]
    [InlineData(-90.0, 0.3, -90, 0)]
    public void SampleRow_PointOnATile_HasItsIndexAmongAllTiles(double latitude, double longitude, int south, int west)
    {
        Vector3D below = new SelenographicPoint(
            double.DegreesToRadians(latitude), double.DegreesToRadians(longitude)).ToDirectionBodyFixed();
        Vector3D axis = Vector3D.Cross(-Vector3D.UnitX, -below);
        UnitQuaternion down = UnitQuaternion.FromAxisAngle(axis, Vector3D.AngleBetween(-Vector3D.UnitX, -below));
        SphereTruth truth = new(new PinholeCamera(2e6 * below, down, 1e-6, 1, 1), Sun, 4);

        int tile = (int)Assert.Single(PixelOf(truth, 1, 1, "tile"));

        Assert.Equal(new TileId(south, west), TileId.All.ElementAt(tile));
    }

    /// <summary>Looks along -x: y is right (east at the centre), z is up.</summary>
    private static PinholeCamera NadirCamera(int width, int height) =>
        new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.Identity, 1.0, width, height);

    /// <summary>A pixel that shows one point.</summary>
    private static FunctionTruth TruthOf(Vector3D point, Vector3D normal) => new(
        NadirCamera(1, 1), Sun,
        (_, _) => (new SurfaceHit(point, normal, new FacetId(1, 1, FacetHalf.SouthWest), 1.0),
            new PixelIllumination(IlluminationState.Lit, 1.0)));

    private static double[][] Sample(SphereTruth truth, params string[] names)
    {
        LayerSampler sampler = new(truth, Provenance);
        IReadOnlyList<Layer> layers = LayerSet.Parse(string.Join(',', names)).Layers;
        double[][] planes = Planes(layers, sampler.Width * sampler.Height);
        for (int row = 0; row < sampler.Height; row++)
        {
            sampler.SampleRow(row, layers, planes, row * sampler.Width);
        }

        return planes;
    }

    /// <summary>The values of one pixel, in the order of the catalogue.</summary>
    private static double[] PixelOf(IGroundTruth truth, int x, int y, params string[] names)
    {
        LayerSampler sampler = new(truth, Provenance);
        IReadOnlyList<Layer> layers = LayerSet.Parse(string.Join(',', names)).Layers;
        double[][] planes = Planes(layers, sampler.Width);
        sampler.SampleRow(y - 1, layers, planes, start: 0);
        return [.. planes.Select(plane => plane[x - 1])];
    }

    private static double[][] Planes(IReadOnlyList<Layer> layers, int length) =>
        [.. layers.SelectMany(layer => Enumerable.Range(0, layer.Planes)).Select(_ => new double[length])];
}
