using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.Adapters.RealImages;

/// <summary>Where a cube's tables say that the camera and the Sun were.</summary>
/// <remarks>
/// As ISIS reads them: attitudes turn at a constant rate between records, positions are cubic between neighbours by their velocities
/// (HermiteSpline) or straight (Linear). Quaternions and ConstantRotation turn J2000 into the instrument's, or the body's, frame.
/// </remarks>
public sealed class CubeStates
{
    /// <summary>s: tables that ISIS made for the times of an image end as much before or after them by rounding.</summary>
    private const double OfRounding = 2e-3;

    private const string Time = "ET";

    private static readonly string[] Attitude = ["J2000Q0", "J2000Q1", "J2000Q2", "J2000Q3", Time];

    private static readonly string[] Position = ["J2000X", "J2000Y", "J2000Z", Time];

    private readonly string _path;
    private readonly (AttitudeSamples Samples, UnitQuaternion Constant) _instrument;
    private readonly (AttitudeSamples Samples, UnitQuaternion Constant) _body;
    private readonly StateSamples _position;
    private readonly StateSamples _sun;

    /// <summary>Reads the tables.</summary>
    /// <param name="tables">Those of a cube.</param>
    /// <param name="path">The cube, for messages.</param>
    /// <exception cref="BadInputException">A table is missing, damaged, or of another form.</exception>
    public CubeStates(CubeTables tables, string path)
    {
        _path = path;
        _instrument = Attitudes(tables, "InstrumentPointing");
        _body = Attitudes(tables, "BodyRotation");
        _position = Positions(tables, "InstrumentPosition");
        _sun = Positions(tables, "SunPosition");
    }

    /// <summary>The camera at a time.</summary>
    /// <param name="axes">How the image lies in the instrument's frame.</param>
    /// <exception cref="BadInputException">The tables do not reach to the time.</exception>
    public CameraState At(TdbTime tdb, InstrumentAxes axes)
    {
        UnitQuaternion bodyFromJ2000 = Turn(_body, tdb, "BodyRotation");
        UnitQuaternion instrumentFromJ2000 = Turn(_instrument, tdb, "InstrumentPointing");
        return new CameraState(
            bodyFromJ2000 * (_position.At(Within(_position.Times, tdb, "InstrumentPosition")).Position),
            bodyFromJ2000 * instrumentFromJ2000.Conjugate * axes.InstrumentFromCamera);
    }

    /// <summary>The Sun at a time, m, in the body's frame.</summary>
    /// <exception cref="BadInputException">The tables do not reach to the time.</exception>
    public Vector3D SunAt(TdbTime tdb) => Turn(_body, tdb, "BodyRotation") * (
        _sun.At(_sun.Count == 1 ? _sun.Times.First : Within(_sun.Times, tdb, "SunPosition")).Position);

    private static bool Covers(SampleTimes times, TdbTime tdb) =>
        tdb - times.First >= -OfRounding && tdb - times.Last <= OfRounding;

    private UnitQuaternion Turn((AttitudeSamples Samples, UnitQuaternion Constant) of, TdbTime tdb, string name) =>
        of.Constant * of.Samples.At(Within(of.Samples.Times, tdb, name));

    private TdbTime Within(SampleTimes times, TdbTime tdb, string name) => Covers(times, tdb)
        ? tdb < times.First ? times.First : tdb > times.Last ? times.Last : tdb
        : throw new BadInputException(Invariant(
            $"{_path}: table {name} reaches from {times.First.Seconds:F3} to {times.Last.Seconds:F3} (TDB seconds past J2000), and the "
                + $"image needs {tdb.Seconds:F3}. The cube's tables are not of these times: run ISIS's spiceinit on it again."));

    private (AttitudeSamples Samples, UnitQuaternion Constant) Attitudes(CubeTables tables, string name)
    {
        CubeTable table = tables.Read(name, Attitude);
        AttitudeSamples samples = new();
        foreach (double[] row in table.Rows)
        {
            Rising(table, samples.Times, row[^1]);
            samples.Add(row[^1], Named(table, () => UnitQuaternion.FromComponents(row[1], row[2], row[3], row[0], isRounded: true)));
        }

        return (samples, ConstantOf(table));
    }

    private StateSamples Positions(CubeTables tables, string name)
    {
        CubeTable table = tables.Read(name, Position);
        string kind = table.Label.Find("CacheType")?.Text ?? "Linear";
        bool hasVelocities = table.Columns.Count > Position.Length;
        StateSamples samples = new()
        {
            Interpolation = kind switch
            {
                "HermiteSpline" when hasVelocities => new Interpolation(InterpolationMethod.Hermite, 3),
                "Linear" => new Interpolation(InterpolationMethod.Lagrange, 1),
                _ => throw new BadInputException(
                    $"{_path}: table {name} has the CacheType {kind}; HermiteSpline with velocities and Linear are known. Run ISIS's "
                        + "spiceinit on the cube again."),
            },
        };
        foreach (double[] row in table.Rows)
        {
            Rising(table, samples.Times, row[^1]);
            samples.Add(row[^1], new StateVector(
                1000.0 * new Vector3D(row[0], row[1], row[2]),
                hasVelocities ? 1000.0 * new Vector3D(row[3], row[4], row[5]) : default));
        }

        return samples;
    }

    private void Rising(CubeTable table, SampleTimes times, double time)
    {
        if (times.Count > 0 && !(time > times.Last))
        {
            throw new BadInputException($"{_path}: the times of table {table.Name} do not rise. Run ISIS's spiceinit on the cube again.");
        }
    }

    private UnitQuaternion ConstantOf(CubeTable table)
    {
        if (table.Label.Find("ConstantRotation") is not { } value)
        {
            return UnitQuaternion.Identity;
        }

        double[] numbers = [.. (value.Items ?? []).Select(item => Number(table, item))];
        return numbers.Length == 9
            ? Named(table, () => GivenRotation.OfMatrix(numbers, isRounded: true))
            : throw new BadInputException($"{_path}: ConstantRotation of table {table.Name} has {numbers.Length} numbers; 9 are needed.");
    }

    private double Number(CubeTable table, PdsValue item) =>
        double.TryParse(item.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
            ? number
            : throw new BadInputException($"{_path}: ConstantRotation of table {table.Name}: '{item.Text}' is not a number.");

    private T Named<T>(CubeTable table, Func<T> read)
    {
        try
        {
            return read();
        }
        catch (BadInputException exception)
        {
            throw new BadInputException($"{_path}: table {table.Name}: {exception.Message}", exception);
        }
    }
}
