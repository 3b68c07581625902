namespace Msisf.Core.Render;

/// <summary>Who made an image.</summary>
public enum RendererKind
{
    /// <summary>POV-Ray, from the pattern files.</summary>
    PovRay,

    /// <summary>The program itself, from the elevation model.</summary>
    Native,
}
