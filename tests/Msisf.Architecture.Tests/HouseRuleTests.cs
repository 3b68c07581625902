using System.Reflection;
using System.Runtime.CompilerServices;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Architecture.Tests;

/// <summary>The rules of the house that reflection can see.</summary>
public sealed class HouseRuleTests
{
    private static readonly Type[] OwnTypes =
    [
        .. ((string[])["Msisf.Core", "Msisf.Adapters", "Msisf.MySql", "Msisf.App"])
            .SelectMany(name => Assembly.Load(name).GetTypes())
            .Where(type => type.GetCustomAttribute<CompilerGeneratedAttribute>() is null && !type.FullName!.Contains('<', StringComparison.Ordinal)),
    ];

    [Fact]
    public void Structs_AreReadOnly() =>
        Assert.All(
            OwnTypes.Where(type => type.IsValueType && !type.IsEnum && type.IsPublic),
            type => Assert.True(type.GetCustomAttribute<IsReadOnlyAttribute>() is not null, $"{type.FullName} is a mutable struct"));

    [Fact]
    public void StaticFields_AreReadOnly() =>
        Assert.All(
            OwnTypes.SelectMany(type => type.GetFields(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly)),
            field => Assert.True(
                field.IsInitOnly || field.IsLiteral || field.DeclaringType!.FullName!.StartsWith("Msisf.Adapters.Interop.", StringComparison.Ordinal)
                    || field.GetCustomAttribute<CompilerGeneratedAttribute>() is not null,
                $"{field.DeclaringType!.FullName}.{field.Name} is mutable and static"));

    [Fact]
    public void Exceptions_DeriveFromMsisfException() =>
        Assert.All(
            OwnTypes.Where(type => typeof(Exception).IsAssignableFrom(type)),
            type => Assert.True(typeof(MsisfException).IsAssignableFrom(type), $"{type.FullName} has no exit code"));

    [Fact]
    public void ConcreteClasses_AreSealed() =>
        Assert.All(
            OwnTypes.Where(type => type.IsClass && type.IsPublic && !type.IsAbstract && !OwnTypes.Any(other => other.BaseType == type)),
            type => Assert.True(type.IsSealed, $"{type.FullName} is not sealed"));

    [Fact]
    public void PublicTypes_LieInTheFileOfTheirName()
    {
        HashSet<string> files =
        [
            .. Directory
                .EnumerateFiles(Path.Combine(TestSupport.TestParts.RepositoryRoot, "src"), "*.cs", SearchOption.AllDirectories)
                .Select(path => Path.GetFileNameWithoutExtension(path)),
        ];
        Assert.All(
            OwnTypes.Where(type => type.IsPublic),
            type => Assert.Contains(type.Name.Split('`')[0], files));
    }
}
