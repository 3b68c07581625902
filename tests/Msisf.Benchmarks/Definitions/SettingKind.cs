namespace Msisf.Benchmarks.Definitions;

/// <summary>Whose way an image is made in.</summary>
internal enum SettingKind
{
    /// <summary>The thesis's: the base line.</summary>
    Thesis,

    /// <summary>msis with POV-Ray.</summary>
    PovRay,

    /// <summary>msis with its own renderer.</summary>
    Native,
}
