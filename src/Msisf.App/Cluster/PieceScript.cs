using Msisf.Core.Scene;

namespace Msisf.App.Cluster;

/// <summary>The content of a script that makes a run in pieces, independent of the script's format.</summary>
internal sealed record PieceScript
{
    /// <summary>Full path of the script itself.</summary>
    public required string Path { get; init; }

    /// <summary>The call that made the script, as one line for the script's head.</summary>
    public required string Call { get; init; }

    /// <summary>Version of the program.</summary>
    public required string Version { get; init; }

    /// <summary>Full path of the file that starts the program.</summary>
    public required string Launcher { get; init; }

    /// <summary>Full path of the folder in which the call was made; relative paths in its options start there.</summary>
    public required string WorkingFolder { get; init; }

    /// <summary>Arguments of the call that makes a piece, except <c>--frames</c>.</summary>
    public required IReadOnlyList<string> Arguments { get; init; }

    /// <summary>Whether <see cref="Arguments"/> say how many frames are made at once.</summary>
    public required bool HasJobs { get; init; }

    /// <summary>Whether the run needs patterns.</summary>
    public required bool NeedsPatterns { get; init; }

    /// <summary>Arguments of the call of <c>msis patterns</c> that makes the patterns before the pieces.</summary>
    public required IReadOnlyList<string> PatternArguments { get; init; }

    /// <summary>Folder of the outputs, as given in the options.</summary>
    public required string OutputFolder { get; init; }

    public required IReadOnlyList<StepRanges> Pieces { get; init; }
}
