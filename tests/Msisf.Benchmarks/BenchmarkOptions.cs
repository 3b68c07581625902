using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Fronts;
using Msisf.Core.Terrain;
using Msisf.Stress;

namespace Msisf.Benchmarks;

/// <summary>What benchmark.sh asks for: pairs of an option and its value, and --quick.</summary>
internal sealed class BenchmarkOptions
{
    private BenchmarkOptions(ILookup<string, string> values, bool isQuick)
    {
        Root = Single(values, "--root");
        Folder = Single(values, "--folder");
        Models = [.. values["--model"]];
        StressTests = ChosenTests(values["--tests"].LastOrDefault());
        IsQuick = isQuick;
        Names = values["--scenes"].LastOrDefault() is string names
            ? names.Split(',', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)
            : isQuick
                ? Scenes.QuickNames
                : [.. Scenes.All.Select(scene => scene.Name), Scenes.FromNothing, Scenes.Sequence, Scenes.Descent, Scenes.Detector];
        Chosen = [.. Names.Where(
            name =>
                name is not (Scenes.Sequence or Scenes.Descent or Scenes.FromNothing or Scenes.Detector))
            .Select(Scenes.Named).Select(scene => isQuick ? Quick(scene) : scene)];
    }

    /// <summary>The repository's folder.</summary>
    public string Root { get; }

    /// <summary>The folder of the benchmark's own files.</summary>
    public string Folder { get; }

    /// <summary>Labels of the elevation models.</summary>
    public IReadOnlyList<string> Models { get; }

    /// <summary>The stress tests that are to be run.</summary>
    public IReadOnlyList<IStressTest> StressTests { get; }

    public bool IsQuick { get; }

    public Repeats Repeats => IsQuick ? Repeats.Quick : Repeats.Full;

    public IReadOnlyList<Scene> Chosen { get; }

    public bool HasSequence => Names.Contains(Scenes.Sequence);

    public bool HasDescent => Names.Contains(Scenes.Descent);

    public bool HasDetector => Names.Contains(Scenes.Detector);

    public bool HasFromNothing => Names.Contains(Scenes.FromNothing);

    /// <summary>Names of the models that the run needs: samples a degree, as "64", or metres a pixel of a polar map, as "20m".</summary>
    public IEnumerable<string> ModelNames =>
        Chosen.Select(scene => scene.Model)
            .Concat(HasSequence ? [GridResolution.FromPixelsPerDegree(Repeats.SequencePixelsPerDegree)] : [])
            .Concat(HasDescent ? [GridResolution.FromPixelsPerDegree(4)] : [])
            .Concat(HasFromNothing ? [FromNothing.Image.Model] : [])
            .Distinct()
            .OrderBy(model => model.PixelsPerDegree is null)
            .ThenBy(model => model.Number)
            .Select(model => model.PixelsPerDegree is null ? model.NumberText + "m" : model.NumberText);

    private IReadOnlyList<string> Names { get; }

    /// <summary>Reads the arguments behind the command word.</summary>
    /// <exception cref="BenchmarkException">One is unknown or lacks its value, or a scene is unknown.</exception>
    public static BenchmarkOptions Parse(IEnumerable<string> arguments)
    {
        List<(string Name, string Value)> values = [];
        bool isQuick = false;
        using IEnumerator<string> words = arguments.GetEnumerator();
        while (words.MoveNext())
        {
            string name = words.Current;
            if (name == "--quick")
            {
                isQuick = true;
            }
            else if (name is "--root" or "--folder" or "--model" or "--scenes" or "--tests" && words.MoveNext())
            {
                values.Add((name, words.Current));
            }
            else
            {
                throw new BenchmarkException($"{name} is unknown or lacks its value.");
            }
        }

        return new BenchmarkOptions(values.ToLookup(pair => pair.Name, pair => pair.Value), isQuick);
    }

    private static IReadOnlyList<IStressTest> ChosenTests(string? names) => names is null
        ? Msisf.Stress.StressTests.All
        : [.. names.Split(',', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries).Select(name =>
            Msisf.Stress.StressTests.All.FirstOrDefault(test => test.Name == name)
                ?? throw new BenchmarkException($"there is no stress test {name}; known: "
                    + $"{string.Join(", ", Msisf.Stress.StressTests.All.Select(test => test.Name))}."))];

    private static Scene Quick(Scene scene) => scene with { Settings = [.. scene.Settings.Intersect(Settings.Few)] };

    private static string Single(ILookup<string, string> values, string name) => values[name].LastOrDefault() ?? ".";
}
