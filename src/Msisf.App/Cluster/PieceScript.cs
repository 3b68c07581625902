using Msisf.Core.Scene;

namespace Msisf.App.Cluster;

/// <summary>What a script of any format is made of.</summary>
internal sealed record PieceScript
{
    /// <summary>Full path of the script itself.</summary>
    public required string Path { get; init; }

    /// <summary>Which call made it, for its head; one line.</summary>
    public required string Call { get; init; }

    /// <summary>Version of the program.</summary>
    public required string Version { get; init; }

    /// <summary>Full path of what starts the program.</summary>
    public required string Launcher { get; init; }

    /// <summary>Full path of the folder in which the call was made: the relative paths of its options begin there.</summary>
    public required string WorkingFolder { get; init; }

    /// <summary>Of each piece's call, but for <c>--frames</c>.</summary>
    public required IReadOnlyList<string> Arguments { get; init; }

    /// <summary>Whether <see cref="Arguments"/> say how many frames are made at once.</summary>
    public required bool HasJobs { get; init; }

    /// <summary>Whether the run needs patterns.</summary>
    public required bool NeedsPatterns { get; init; }

    /// <summary>Of the call of <c>msis patterns</c> that makes them beforehand.</summary>
    public required IReadOnlyList<string> PatternArguments { get; init; }

    /// <summary>Folder of the outputs, as the options have it.</summary>
    public required string OutputFolder { get; init; }

    public required IReadOnlyList<StepRanges> Pieces { get; init; }
}
