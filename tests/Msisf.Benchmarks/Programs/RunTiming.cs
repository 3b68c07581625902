using System.Text.Json;

namespace Msisf.Benchmarks.Programs;

/// <summary>What <c>--timing</c> says of a run.</summary>
internal sealed class RunTiming
{
    private const string SecondsEnding = "_s";

    private readonly Dictionary<string, double> _numbers;

    private RunTiming(Dictionary<string, double> numbers) => _numbers = numbers;

    /// <summary>Most memory that msis held, bytes; without POV-Ray's.</summary>
    public double PeakMemoryBytes => this["peak_memory_bytes"];

    /// <summary>Seconds of each phase that took any, in the order of the run; "total" is not one of them.</summary>
    public IEnumerable<(string Phase, double Seconds)> Phases =>
        from number in _numbers
        where number.Key.EndsWith(SecondsEnding, StringComparison.Ordinal) && number.Key != "total_s" && number.Value > 0.0
        select (number.Key[..^SecondsEnding.Length], number.Value);

    /// <summary>Seconds of a phase; 0 if there is none of this name.</summary>
    public double SecondsOf(string phase) => _numbers.GetValueOrDefault(phase + SecondsEnding);

    /// <summary>A count, e.g. "tiles"; null if msis names none.</summary>
    public double? CountOf(string name) => _numbers.TryGetValue(name, out double value) ? value : null;

    private double this[string name] => _numbers.TryGetValue(name, out double value)
        ? value
        : throw new BenchmarkException($"msis --timing says nothing of {name}; it says {string.Join(", ", _numbers.Keys)}.");

    /// <summary>Finds the line of JSON.</summary>
    /// <param name="run">A run with --timing.</param>
    public static RunTiming Of(ProgramRun run)
    {
        string line = run.Errors.LastOrDefault(text => text.StartsWith('{'))
            ?? throw new BenchmarkException($"msis --timing has printed no line of JSON, but: {string.Join(" / ", run.Errors)}");
        using JsonDocument document = JsonDocument.Parse(line);
        return new RunTiming(
            document.RootElement.EnumerateObject().ToDictionary(property => property.Name, property => property.Value.GetDouble()));
    }
}
