using System.CommandLine;
using System.Globalization;
using System.Text;
using Msisf.Adapters.Input;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Cli.Options;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.Cli.Pieces;

/// <summary>
/// The states of the spacecraft that a run takes images of, from any of the four modes; all are known before the first image.
/// </summary>
internal sealed class StateSource
{
    private readonly ModeOptions _options;
    private readonly ParseResult _line;
    private readonly Func<IEphemeris> _ephemeris;
    private readonly Func<TextReader> _standardInput;
    private readonly ILog _log;

    public StateSource(ModeOptions options, ParseResult line, Func<IEphemeris> ephemeris, Func<TextReader> standardInput, ILog log)
    {
        _options = options;
        _line = line;
        _ephemeris = ephemeris;
        _standardInput = standardInput;
        _log = log;
    }

    /// <summary>Reads or computes all states.</summary>
    /// <param name="mode">How they are given.</param>
    /// <param name="cancellation">Ends the wait for a terminal or pipe too.</param>
    /// <exception cref="NothingToRenderException">There is none.</exception>
    public IReadOnlyList<SpacecraftState> Read(Mode mode, CancellationToken cancellation)
    {
        IReadOnlyList<SpacecraftState> states = mode switch
        {
            Mode.FixedState => [FixedState()],
            Mode.BatchFile => BatchFile(cancellation),
            Mode.Kepler => OnOrbit(KeplerElements(), cancellation),
            _ => OnOrbit(OptionText.Named(_options.StateVectors, () => StateConversion.ToElements(StateVector())), cancellation),
        };
        return states.Count > 0
            ? states
            : throw new NothingToRenderException(mode == Mode.BatchFile
                ? $"{BatchFileName}: no state in it: only comments and empty lines. Add lines of MJD rx ry rz qx qy qz q0."
                : "--time-interval: no time in it: the step leads away from the end. Swap start and end, or change the step's sign.");
    }

    private SpacecraftState FixedState()
    {
        double[] values = Numbers(_options.FixedState, SpacecraftState.NumberNames);
        return OptionText.Named(_options.FixedState, () => SpacecraftState.FromNumbers(values));
    }

    private string BatchFileName => _line.GetValue(_options.BatchFile) is string name and not "-" ? name : "standard input";

    // A read from a terminal or pipe can't be cancelled: it is left behind.
    private IReadOnlyList<SpacecraftState> BatchFile(CancellationToken cancellation) =>
        Task.Run(BatchFile, CancellationToken.None).WaitAsync(cancellation).GetAwaiter().GetResult();

    private IReadOnlyList<SpacecraftState> BatchFile()
    {
        string path = OptionText.FilePath(_options.BatchFile, _line.GetValue(_options.BatchFile)!);
        if (path == "-")
        {
            return BatchFileReader.Read(_standardInput(), BatchFileName);
        }

        if (!File.Exists(path))
        {
            throw new BadInputException(Directory.Exists(path)
                ? $"{_options.BatchFile.Name} {path}: is a folder; a file is needed."
                : $"{_options.BatchFile.Name} {path}: there is no such file.");
        }

        return FileErrors.ToBadInput($"{_options.BatchFile.Name} {path}: can't be read", () =>
        {
            using StreamReader reader = new(path, Encoding.UTF8);
            return BatchFileReader.Read(reader, path);
        });
    }

    private KeplerElements KeplerElements()
    {
        double[] values = Numbers(_options.KeplerSet, ["a", "e", "omega", "Omega", "i", "M0"]);
        return OptionText.Named(
            _options.KeplerSet, () => new KeplerElements(values[0], values[1], values[2], values[3], values[4], values[5]));
    }

    private StateVector StateVector()
    {
        double[] values = Numbers(_options.StateVectors, ["rx", "ry", "rz", "drx", "dry", "drz"]);
        return new StateVector(new Vector3D(values[0], values[1], values[2]), new Vector3D(values[3], values[4], values[5]));
    }

    private SpacecraftState[] OnOrbit(KeplerElements elements, CancellationToken cancellation)
    {
        ModifiedJulianDate epoch = Date(_options.Epoch, _line.GetValue(_options.Epoch)!);
        OrbitFrame frame = _line.GetValue(_options.OrbitFrame) is string text
            ? OptionText.Choice(
                _options.OrbitFrame,
                text,
                [("moon-me", OrbitFrame.MoonMe), ("moon-me-epoch", OrbitFrame.MoonMeEpoch), ("j2000", OrbitFrame.J2000)])
            : OrbitFrame.MoonMe;
        OrbitPropagator orbit = new(elements, epoch, frame, frame == OrbitFrame.MoonMe ? null : _ephemeris());
        if (orbit.PeriapsisRadius < MoonConstants.ReferenceRadius)
        {
            _log.Warning(string.Create(
                CultureInfo.InvariantCulture,
                $"the orbit's periapsis lies {(MoonConstants.ReferenceRadius - orbit.PeriapsisRadius) / 1000.0:F3} km below the Moon's "
                    + $"reference radius; times on that part are refused."));
        }

        AttitudeTransition? attitude = Attitude();
        return [.. Times().Select(time =>
        {
            cancellation.ThrowIfCancellationRequested();
            Vector3D position = orbit.PositionMoonMe(time);
            return new SpacecraftState(time, position, attitude?.At(time.SecondsSince(epoch)) ?? NadirPointing.MoonFromCamera(position));
        })];
    }

    private AttitudeTransition? Attitude()
    {
        if (_line.GetResult(_options.Attitude) is null)
        {
            return null;
        }

        double[] q = Numbers(_options.Attitude, ["qx", "qy", "qz", "q0"]);
        double[] rates = _line.GetResult(_options.AttitudeTransition) is null
            ? [0.0, 0.0, 0.0]
            : Numbers(_options.AttitudeTransition, ["wx", "wy", "wz"]);
        return OptionText.Named(_options.Attitude, () => new AttitudeTransition(
            UnitQuaternion.FromComponents(q[0], q[1], q[2], q[3]), new Vector3D(rates[0], rates[1], rates[2])));
    }

    private IEnumerable<ModifiedJulianDate> Times()
    {
        if (_line.GetValue(_options.Time) is string time)
        {
            return [Date(_options.Time, time)];
        }

        return _line.GetResult(_options.Times) is not null
            ? StateText.ParseList(_options.Times.Name, _line.GetValue(_options.Times)!, "MJD")
                .Select(mjd => OptionText.Named(_options.Times, () => new ModifiedJulianDate(mjd)))
            : StateText.ParseInterval(_options.TimeInterval.Name, [_line.GetValue(_options.TimeInterval)!]);
    }

    private double[] Numbers(Option<string[]> option, IReadOnlyList<string> fields) =>
        StateText.ParseNumbers(option.Name, _line.GetValue(option)!, fields);

    private static ModifiedJulianDate Date(Option option, string text)
    {
        double days = OptionText.Number(option, text);
        return OptionText.Named(option, () => new ModifiedJulianDate(days));
    }
}
