namespace Msisf.Core.Render.Visibility;

/// <summary>A projected vertex.</summary>
/// <param name="X">Column.</param>
/// <param name="Y">Row.</param>
/// <param name="InverseDepth">1/m: one over its depth.</param>
internal readonly record struct CellCorner(double X, double Y, double InverseDepth)
{
    public CellCorner(ProjectedBlock block, int index)
        : this(block.X[index], block.Y[index], block.InverseDepth[index])
    {
    }
}
