using System.Text.Json;
using Msisf.Benchmarks;
using Msisf.Benchmarks.Measures;
using Msisf.Benchmarks.Micro;
using Msisf.Benchmarks.Programs;
using Msisf.Benchmarks.Reports;
using Msisf.Benchmarks.Thesis;
using Msisf.Core.Errors;
using Msisf.Stress;

// benchmark.sh is the way to start it.
const string Usage = """
    measure     [--quick] [--scenes NAME,...] --root DIR --folder DIR --model LABEL...
                measures; writes tables.md, figures.csv, targets.csv
    resolutions [--quick] [--scenes NAME,...]
                prints which elevation models that needs: px/deg, or m/px of polar maps, as 20m
    fill        LABEL
                completes a part of a model by flat ground
    stress      [--quick] [--tests NAME,...] --folder DIR
                runs stress tests; writes tables.md, stress.csv, stress_machine.csv, stress_series.csv
    micro       [BenchmarkDotNet's options]
                micro-benchmarks
    """;
try
{
    switch (args.FirstOrDefault())
    {
        case "measure":
            BenchmarkOptions options = BenchmarkOptions.Parse(args.Skip(1));
            BenchmarkResult result = BenchmarkRun.Measure(options, Console.Error);
            ResultFiles.Write(options.Folder, result);
            return 0;
        case "resolutions":
            Console.WriteLine(string.Join(' ', BenchmarkOptions.Parse(args.Skip(1)).ModelNames));
            return 0;
        case "fill" when args.Length == 2:
            FlatGround.Fill(args[1]);
            return 0;
        case "stress":
            BenchmarkOptions stressOptions = BenchmarkOptions.Parse(args.Skip(1));
            StressResult stressResult = StressRun.Measure(
                stressOptions.IsQuick ? StressLength.Everyday : StressLength.Full, stressOptions.StressTests, Console.Out);
            StressFiles.Write(stressOptions.Folder, stressResult);
            return 0;
        case "micro":
            MicroBenchmarks.Run([.. args.Skip(1)]);
            return 0;
        case FurtherFramesJob.Command:
            FurtherFramesJob job = JsonSerializer.Deserialize<FurtherFramesJob>(args[1])!;
            using (Sun sun = Sun.Open(Environment.CurrentDirectory))
            {
                Console.WriteLine(JsonSerializer.Serialize(FurtherFramesChild.Run(job, sun.Ephemeris)));
            }

            return 0;
        case SampledFramesJob.Command:
            SampledFramesJob sampled = JsonSerializer.Deserialize<SampledFramesJob>(args[1])!;
            using (Sun sun = Sun.Open(Environment.CurrentDirectory))
            {
                Console.WriteLine(JsonSerializer.Serialize(SampledFramesChild.Run(sampled, sun.Ephemeris)));
            }

            return 0;
        case ThesisFrameJob.Command:
            ThesisFrameJob thesis = JsonSerializer.Deserialize<ThesisFrameJob>(args[1])!;
            using (Sun sun = Sun.Open(Environment.CurrentDirectory))
            {
                Console.Error.WriteLine(JsonSerializer.Serialize(ThesisFrame.Run(thesis, sun.Ephemeris)));
            }

            return 0;
        default:
            Console.Error.WriteLine(Usage);
            return 1;
    }
}
catch (Exception exception) when (exception is BenchmarkException or MsisfException)
{
    Console.Error.WriteLine($"benchmark: {exception.Message}");
    return 1;
}
