namespace Msisf.App.Settings;

/// <summary>The format of a script: which program runs the pieces of a run.</summary>
internal enum ScriptFormat
{
    /// <summary>A POSIX shell, one after another.</summary>
    Sh,

    /// <summary>Windows's cmd, one after another.</summary>
    Bat,

    /// <summary>GNU parallel, several at once.</summary>
    Parallel,

    /// <summary>Slurm, as a job array.</summary>
    Slurm,
}
