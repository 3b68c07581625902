namespace Msisf.App.Settings;

/// <summary>Settings of the Slurm jobs, and of the last job, which merges the run.</summary>
internal sealed record SlurmSettings
{
    /// <summary>Maximum number of pieces at once; null for no limit.</summary>
    public required int? Concurrency { get; init; }

    /// <summary>Number of CPUs per piece, which is also the number of frames at once unless the run has --jobs.</summary>
    public required int CpusPerTask { get; init; }

    /// <summary>Memory per piece in the syntax of sbatch, e.g. "4G"; null for the cluster's default.</summary>
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

    /// <summary>Time limit of a piece in the syntax of sbatch, e.g. "2:00:00"; null for the partition's default.</summary>
    public required string? TimeLimit { get; init; }

    public required string? Partition { get; init; }

    public required string? Account { get; init; }

    /// <summary>Further options of sbatch, without their dashes.</summary>
    public required IReadOnlyList<string> MoreOptions { get; init; }

    /// <summary>How many times missing frames are submitted again.</summary>
    public required int Retries { get; init; }

    /// <summary>Options of <c>msis merge</c>, which the last job runs.</summary>
    public required IReadOnlyList<string> MergeOptions { get; init; }

    private static long Count(string digits, int powerOfTwo) => long.Parse(digits, CultureInfo.InvariantCulture) << powerOfTwo;
}
