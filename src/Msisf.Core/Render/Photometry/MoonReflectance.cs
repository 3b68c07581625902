namespace Msisf.Core.Render.Photometry;

/// <summary>The default law: <see cref="HapkeReflectance"/> with the Moon's parameters in a band.</summary>
public static class MoonReflectance
{
    /// <summary>The law as a user names it.</summary>
    public static ReflectanceLaw Law { get; } = new("moon", values => new HapkeReflectance(values.Band.Moon)) { HasOwnBrightness = true };
}
