namespace Msisf.App.Settings;

/// <summary>Defaults and limits of where elevations and patterns come from.</summary>
internal static class SourceSettings
{
    /// <summary>The thesis's folder of patterns, below the working directory.</summary>
    public const string DefaultRepository = "pattern-repository";

    /// <summary>px/deg: the finest product that NASA offers (LDEM_1024).</summary>
    public const int FinestResolution = 1024;
}
