using Msisf.Core.Attitude;
using Msisf.Core.Illumination;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.DataSets;

/// <summary>Makes the states of a data set from points of the unit cube.</summary>
/// <param name="spec">What the data set asks for.</param>
/// <param name="scene">The terrain.</param>
internal sealed class StateMaker(DataSetSpec spec, ISceneGeometry scene)
{
    /// <summary>m: the Sun's mean distance.</summary>
    private const double SunDistance = 1.495978707e11;

    /// <summary>The states of one image, or of both of a pair.</summary>
    /// <param name="candidate">Number of the point.</param>
    public DrawnState[] Of(Split split, long candidate, double[] point)
    {
        Dictionary<Quantity, double> drawn = spec.Distributions.ToDictionary(
            entry => entry.Key, entry => entry.Value.Quantile(point[entry.Key.Coordinate]));
        ((double latitude, double longitude), Region region) = split.At(point[0], point[1]);
        Vector3D position = new SurfacePlace(latitude, longitude, drawn[Quantity.Altitude], isOverTerrain: true)
            .ToPositionBodyFixed(scene.GroundRadius, scene.ReferenceRadius);
        ModifiedJulianDate time = new(drawn[Quantity.Time]);
        UnitQuaternion pointing = new CameraPointing
        {
            Kind = BoresightKind.OffNadir,
            OffNadir = double.DegreesToRadians(drawn[Quantity.OffNadir]),
            Azimuth = double.DegreesToRadians(drawn[Quantity.Azimuth]),
            Roll = double.DegreesToRadians(drawn[Quantity.Roll]),
        }.MoonFromCamera(position, time, scene);
        SpacecraftState state = new(time, position, pointing)
        {
            SunPositionBodyFixed = drawn.TryGetValue(Quantity.SunElevation, out double elevation)
                ? SunAt(position, elevation, drawn[Quantity.SunAzimuth])
                : null,
            ExposureFactor = drawn.TryGetValue(Quantity.Exposure, out double factor) ? factor : null,
        };
        DrawnState first = new(split.Name, candidate, region, drawn, state);
        return spec.HasPairs ? [first, first with { State = Moved(state, drawn, point) }] : [first];
    }

    /// <summary>The Sun's place for a direction over the ground below a camera.</summary>
    private Vector3D SunAt(Vector3D positionBodyFixed, double elevationDegrees, double azimuthDegrees)
    {
        LocalFrame below = LocalFrame.At(positionBodyFixed);
        Vector3D direction = below.DirectionOf(double.DegreesToRadians(azimuthDegrees), double.DegreesToRadians(elevationDegrees));
        return (scene.GroundRadius(below.Up) * below.Up) + (SunDistance * direction);
    }

    /// <summary>The state of a pair's second image: shifted in any direction, and turned about any axis.</summary>
    private static SpacecraftState Moved(SpacecraftState state, Dictionary<Quantity, double> drawn, double[] point) => state with
    {
        PositionBodyFixed = state.PositionBodyFixed + (drawn[Quantity.Shift] * Direction(point, Quantity.DirectionOfShift)),
        MoonFromCamera = state.MoonFromCamera * UnitQuaternion.FromAxisAngle(
            Direction(point, Quantity.AxisOfTurn), double.DegreesToRadians(drawn[Quantity.Turn])),
    };

    /// <summary>A direction; directions are as many in each solid angle of the same size.</summary>
    private static Vector3D Direction(double[] point, int coordinate)
    {
        double z = (2.0 * point[coordinate]) - 1.0;
        double across = Math.Sqrt((1.0 - z) * (1.0 + z));
        (double sine, double cosine) = Math.SinCos(2.0 * Math.PI * point[coordinate + 1]);
        return new Vector3D(across * cosine, across * sine, z);
    }
}
