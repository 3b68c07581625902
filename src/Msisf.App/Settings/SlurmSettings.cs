using System.Globalization;

namespace Msisf.App.Settings;

/// <summary>What Slurm is asked for, and what its last job does.</summary>
internal sealed record SlurmSettings
{
    /// <summary>Pieces at once; null for as many as Slurm likes.</summary>
    public required int? Concurrency { get; init; }

    /// <summary>CPUs of a piece; if the run does not say --jobs, as many frames at once.</summary>
    public required int CpusPerTask { get; init; }

    /// <summary>As sbatch takes it, e.g. "4G"; null for the cluster's default.</summary>
    public required string? Memory { get; init; }

    /// <summary><see cref="Memory"/> in bytes; null for the cluster's default.</summary>
    public long? MemoryBytes => Memory is null ? null : Memory[^1] switch
    {
        'K' => Count(Memory[..^1], 10),
        'M' => Count(Memory[..^1], 20),
        'G' => Count(Memory[..^1], 30),
        'T' => Count(Memory[..^1], 40),
        _ => Count(Memory, 20),
    };

    /// <summary>As sbatch takes it, e.g. "2:00:00"; null for the partition's default.</summary>
    public required string? TimeLimit { get; init; }

    public required string? Partition { get; init; }

    public required string? Account { get; init; }

    /// <summary>More options of sbatch, without their dashes.</summary>
    public required IReadOnlyList<string> MoreOptions { get; init; }

    /// <summary>How often missing frames are submitted again.</summary>
    public required int Retries { get; init; }

    /// <summary>Options of <c>msis merge</c> at the end.</summary>
    public required IReadOnlyList<string> MergeOptions { get; init; }

    private static long Count(string digits, int powerOfTwo) => long.Parse(digits, CultureInfo.InvariantCulture) << powerOfTwo;
}
