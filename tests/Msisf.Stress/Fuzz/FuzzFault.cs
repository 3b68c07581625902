namespace Msisf.Stress.Fuzz;

/// <summary>What no input may make the program do.</summary>
[Flags]
internal enum FuzzFault
{
    None = 0,

    /// <summary>Exit code 70, or an exception that escapes.</summary>
    Bug = 1,

    /// <summary>An exit code that the documents do not know.</summary>
    UnknownExitCode = 2,

    /// <summary>Not ended though it was told to.</summary>
    Hang = 4,

    /// <summary>A failure without its line, a line without a failure, or several lines.</summary>
    ErrorLine = 8,

    /// <summary>A temporary file or folder that stays, or an output that is not whole.</summary>
    PartialOutput = 16,

    /// <summary>More memory than a tiny image may ever need.</summary>
    Memory = 32,
}
