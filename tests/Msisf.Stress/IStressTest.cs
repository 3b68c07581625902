namespace Msisf.Stress;

/// <summary>Drives a part of the program with many seeded inputs and keeps the worst it finds.</summary>
public interface IStressTest
{
    /// <summary>Name for files and options, e.g. "kepler".</summary>
    string Name { get; }

    /// <summary>What is driven, and how, in a sentence for the report.</summary>
    string Subject { get; }

    /// <summary>What it can't run without and this machine lacks, e.g. "POV-Ray"; null if nothing is missing.</summary>
    string? MissingPart => null;

    /// <summary>Whether its figures are times and memory, which differ from machine to machine and from run to run.</summary>
    bool IsOfThisMachine => false;

    /// <summary>
    /// Runs it; the same length and seed give the same report, whatever the machine, unless <see cref="IsOfThisMachine"/>.
    /// </summary>
    /// <param name="length">How much of it.</param>
    /// <param name="seed">Of all random inputs.</param>
    StressReport Run(StressLength length, int seed);
}
